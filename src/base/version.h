/* The program's version, as the build system has it. */
#ifndef BASE_VERSION_H
#define BASE_VERSION_H

const char *version_string(void);

#endif
