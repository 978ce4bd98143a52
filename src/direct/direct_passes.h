/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The transforms of direct_kernel.c, which includes this once for each precision: REAL is the type of a value, OF(name)
 * a name here, FFT(name) one of FFTW's, LANES how many values fill 32 bytes, SWAPPED the order that exchanges the parts
 * of complex numbers, REVERSED that which reverses the numbers, BACKWARDS both, TWICE that which repeats each of half
 * as many values. Fields are double in both precisions: a row is converted when it is laid out for its transform. In
 * single precision lengths are in units of the spacing, so that no value leaves its range. */

typedef REAL OF(lanes) __attribute__((vector_size(32), aligned(sizeof(REAL)), may_alias));
typedef REAL OF(half) __attribute__((vector_size(16), aligned(sizeof(REAL)), may_alias));

/** Room, plans and tables. */
struct OF(room) {
    size_t stride;                                      /* complex numbers from row to row: whole blocks of columns */
    REAL *line;                                         /* one row in the order of its transform */
    FFT(complex) * field;                               /* the rows' transforms */
    FFT(complex) * columns;                             /* some of them */
    FFT(complex) * transformed, *multiplied;            /* of a row or a column, and times its factors; [n] is [0] */
    REAL *share;                                        /* fill_share() */
    REAL *turn;                                         /* of a mirrored grid: fill_turn() */
    REAL *table[DIRECT_TABLES];                         /* a column for each wave along x: fill_column() */
    double before[DIRECT_TABLES], after[DIRECT_TABLES]; /* factors of a field as it comes in and goes out */
    FFT(plan) row_forward, row_backward, column_forward, column_backward;
};

/** exp(-i pi k/(2 n)), k = -n ... 2 n, laid out for products: the real part twice, the imaginary part with either sign.
 */
static void OF(fill_turn)(REAL *turn, size_t n)
{
    for (size_t k = 0; k <= 3 * n; k++) {
        double angle = M_PI * ((double)k - (double)n) / (2 * (double)n);
        turn[2 * k] = turn[2 * k + 1] = (REAL)cos(angle);
        turn[2 * (3 * n + 1 + k)] = (REAL)sin(angle);
        turn[2 * (3 * n + 1 + k) + 1] = (REAL)-sin(angle);
    }
}

/** |q|, or its inverse, of wave (i, j), divided by the number of points, by which an unnormalised pair of transforms
 * multiplies. */
static double OF(factor)(const struct direct_kernel *kernel, enum direct_table table, size_t i, size_t j)
{
    double side_m = (kernel->mirrored ? 2 : 1) * (kernel->single ? 1 : kernel->spacing_m), n = (double)kernel->points;
    double q = 2 * M_PI / side_m * hypot((double)i / (double)kernel->nx, (double)j / (double)kernel->ny);
    return table == DIRECT_STIFFNESS ? q / n : q > 0 ? 1 / (q * n) : 0;
}

/** Factors of column i; of a mirrored grid those of multiply_mirrored(): all S, then all D, for both parts. */
static void OF(fill_column)(const struct direct_kernel *kernel, enum direct_table table, REAL *out, size_t i)
{
    const size_t n = kernel->ny, half = n / 2 + 1;
    for (size_t j = 0; j < half && !kernel->mirrored; j++)
        out[j] = (REAL)OF(factor)(kernel, table, i, j);
    for (size_t j = 0; j < half && kernel->mirrored; j++) {
        double near = OF(factor)(kernel, table, i, j), far = OF(factor)(kernel, table, n - i, n - j);
        double down = OF(factor)(kernel, table, i, n - j), right = OF(factor)(kernel, table, n - i, j);
        out[2 * j] = (REAL)((near + far) / 2);
        out[2 * j + 1] = (REAL)((down + right) / 2);
        out[2 * (half + j)] = (REAL)((near - far) / 2);
        out[2 * (half + j) + 1] = (REAL)((right - down) / 2);
    }
}

/** Values of a column of a table. */
static size_t OF(column_length)(const struct direct_kernel *kernel)
{
    return (kernel->ny / 2 + 1) * (kernel->mirrored ? 4 : 1);
}

/** Factors of part_row(): all (1 - sin(2 pi k/n))/2, then all cos(2 pi k/n)/2. */
static void OF(fill_share)(REAL *out, size_t n)
{
    for (size_t k = 0; k <= n / 2; k++) {
        const double angle = 2 * M_PI * (double)k / (double)n;
        out[k] = (REAL)((1 - sin(angle)) / 2);
        out[n / 2 + 1 + k] = (REAL)(cos(angle) / 2);
    }
}

/** Factors of multiply_strip(): all A, then all B. A pair of transforms of `numbers` multiplies by these, not by the
 * points. */
static void OF(fill_strip)(const struct direct_kernel *kernel, enum direct_table table, REAL *out, const REAL *share)
{
    const size_t n = kernel->nx, numbers = numbers_of(n);
    for (size_t k = 0; k < numbers; k++) {
        const size_t place = numbers < n ? k : 0;
        const double f = OF(factor)(kernel, table, k <= n / 2 ? k : n - k, 0);
        const double g = numbers < n ? OF(factor)(kernel, table, numbers - k, 0) : f;
        const double scale = (double)n / (double)numbers, s = (double)share[place];
        out[k] = (REAL)(scale * (s * f + (1 - s) * g));
        out[numbers + k] = (REAL)(scale * (double)share[n / 2 + 1 + place] * (f - g));
    }
}

static void OF(make_plans)(void *context)
{
    struct direct_kernel *kernel = context;
    struct OF(room) *room = kernel->room;
    const int ny = (int)kernel->ny, numbers = (int)numbers_of(kernel->nx);
    FFT(complex) *line = (FFT(complex) *)room->line;
    room->row_forward = FFT(plan_dft_1d)(numbers, line, room->transformed, FFTW_FORWARD, FFTW_ESTIMATE);
    room->row_backward = FFT(plan_dft_1d)(numbers, room->multiplied, line, FFTW_BACKWARD, FFTW_ESTIMATE);
    if (ny == 1)
        return;
    room->column_forward = FFT(plan_dft_1d)(ny, room->columns, room->transformed, FFTW_FORWARD, FFTW_ESTIMATE);
    room->column_backward = FFT(plan_dft_1d)(ny, room->multiplied, room->columns, FFTW_BACKWARD, FFTW_ESTIMATE);
}

static void OF(destroy_plans)(void *context)
{
    struct OF(room) *room = context;
    FFT(destroy_plan)(room->row_forward);
    FFT(destroy_plan)(room->row_backward);
    FFT(destroy_plan)(room->column_forward);
    FFT(destroy_plan)(room->column_backward);
}

static void OF(free)(struct direct_kernel *kernel)
{
    struct OF(room) *room = kernel->room;
    if (!room)
        return;
    fft_plan(OF(destroy_plans), room);
    FFT(free)(room->line);
    FFT(free)(room->field);
    FFT(free)(room->columns);
    FFT(free)(room->transformed);
    FFT(free)(room->multiplied);
    free(room->turn);
    free(room->share);
    for (int k = 0; k < DIRECT_TABLES; k++)
        free(room->table[k]);
    free(room);
}

/** False: out of memory. */
static bool OF(make)(struct direct_kernel *kernel)
{
    struct OF(room) *room = kernel->room = calloc(1, sizeof *room);
    const size_t nx = kernel->nx, ny = kernel->ny, length = OF(column_length)(kernel), numbers = numbers_of(nx);
    const bool strip = ny == 1;
    if (!room)
        return false;
    room->stride = strip ? 0 : (nx / 2 + BLOCK) / BLOCK * BLOCK;
    room->line = FFT(alloc_real)(2 * numbers);
    room->field = FFT(alloc_complex)(ny * room->stride + 1);
    room->columns = FFT(alloc_complex)(BLOCK * (ny + GAP));
    room->transformed = FFT(alloc_complex)((numbers > ny ? numbers : ny) + 1);
    room->multiplied = FFT(alloc_complex)((numbers > ny ? numbers : ny) + 1);
    room->turn = malloc(kernel->mirrored ? 4 * (3 * nx + 1) * sizeof(REAL) : 1);
    room->share = malloc(2 * (nx / 2 + 1) * sizeof(REAL));
    for (int k = 0; k < DIRECT_TABLES; k++)
        room->table[k] = calloc(strip ? 2 * numbers : (nx / 2 + BLOCK) * length, sizeof(REAL));
    if (!room->line || !room->field || !room->columns || !room->transformed || !room->multiplied || !room->turn ||
        !room->share || !room->table[0] || !room->table[1])
        return false;
    memset(room->field, 0, ny * room->stride * sizeof *room->field);
    room->before[DIRECT_COMPLIANCE] = room->after[DIRECT_STIFFNESS] = 1;
    room->after[DIRECT_COMPLIANCE] = kernel->single ? kernel->spacing_m : 1;
    room->before[DIRECT_STIFFNESS] = 1 / room->after[DIRECT_COMPLIANCE];
    fft_plan(OF(make_plans), kernel);
    if (kernel->mirrored)
        OF(fill_turn)(room->turn, nx);
    OF(fill_share)(room->share, nx);
    for (enum direct_table table = 0; table < DIRECT_TABLES; table++) {
        if (strip)
            OF(fill_strip)(kernel, table, room->table[table], room->share);
        for (size_t i = 0; i <= nx / 2 && !strip; i++)
            OF(fill_column)(kernel, table, room->table[table] + i * length, i);
    }
    return true;
}

/** A row of the field in the order of its transform. */
CLONES static void OF(lay_out)(REAL *line, const double *row, size_t n, bool mirrored, double factor)
{
    for (size_t i = 0; !mirrored && i < n; i++)
        line[i] = (REAL)(factor * row[i]);
    for (size_t i = 0; mirrored && i < n / 2; i++) {
        line[i] = (REAL)(factor * row[2 * i]);
        line[n - 1 - i] = (REAL)(factor * row[2 * i + 1]);
    }
    if (mirrored && n % 2)
        line[n / 2] = (REAL)(factor * row[n - 1]);
}

/** The same backwards. */
CLONES static void OF(take_back)(double *row, const REAL *line, size_t n, bool mirrored, double factor)
{
    for (size_t i = 0; !mirrored && i < n; i++)
        row[i] = factor * (double)line[i];
    for (size_t i = 0; mirrored && i < n / 2; i++) {
        row[2 * i] = factor * (double)line[i];
        row[2 * i + 1] = factor * (double)line[n - 1 - i];
    }
    if (mirrored && n % 2)
        row[n - 1] = factor * (double)line[n / 2];
}

/** Transforms a row into `transformed`: two by two, its points are the parts of complex numbers; an odd number of them,
 * or a few, are real parts beside 0. */
static void OF(transform_row)(const struct pass *pass, const double *row)
{
    const struct direct_kernel *kernel = pass->kernel;
    const struct OF(room) *room = kernel->room;
    FFT(complex) *line = (FFT(complex) *)room->line;
    const size_t n = kernel->nx, numbers = numbers_of(n);
    OF(lay_out)(room->line, row, n, kernel->mirrored, room->before[pass->table]);
    for (size_t k = n; numbers == n && k-- > 0;) {
        line[k][0] = room->line[k];
        line[k][1] = 0;
    }
    FFT(execute_dft)(room->row_forward, line, room->transformed);
    memcpy(room->transformed + numbers, room->transformed, sizeof *room->transformed);
}

/** The same backwards, of `multiplied`. */
static void OF(transform_row_back)(const struct pass *pass, double *row)
{
    const struct direct_kernel *kernel = pass->kernel;
    const struct OF(room) *room = kernel->room;
    FFT(complex) *line = (FFT(complex) *)room->line;
    const size_t n = kernel->nx;
    FFT(execute_dft)(room->row_backward, room->multiplied, line);
    for (size_t k = 0; numbers_of(n) == n && k < n; k++)
        room->line[k] = line[k][0];
    OF(take_back)(row, room->line, n, kernel->mirrored, room->after[pass->table]);
}

/** Half as many complex numbers as a row has points hold two of them each. With their transform Z, h of them and Z[h] =
 * Z[0], the row's is X[k] = E + w O, E = (Z[k] + conj Z[h - k])/2, O = (Z[k] - conj Z[h - k])/2i, w = exp(-2 pi i k/n):
 * X[k] = (s - i c) Z[k] + (1 - s + i c) conj Z[h - k] with the shares s = (1 - sin(2 pi k/n))/2 and c = cos(2 pi
 * k/n)/2; back, with i for -i, (`sign` -1) twice that. */
CLONES static void OF(part_row)(FFT(complex) * out, const FFT(complex) * in, size_t count, const REAL *share, size_t h,
                                REAL sign)
{
    enum { NUMBERS = LANES / 2 };
    const OF(lanes) scale = (OF(lanes)){0} + (REAL)(sign < 0 ? 2 : 1);
    OF(lanes) alternate = {0};
    for (size_t i = 0; i < LANES; i++)
        alternate[i] = i % 2 ? -1 : 1;
    for (size_t done = 0; done < count; done += NUMBERS) { /* the last places twice, for the sake of whole lanes */
        const size_t k = done + NUMBERS <= count ? done : count - NUMBERS;
        const OF(lanes) a = *(const OF(lanes) *)(in + k), b = *(const OF(lanes) *)(in + h - k - (NUMBERS - 1));
        const OF(half) half[2] = {*(const OF(half) *)(share + k), *(const OF(half) *)(share + h + 1 + k)};
        const OF(lanes) s = __builtin_shufflevector(half[0], half[0], TWICE);
        const OF(lanes) c = sign * __builtin_shufflevector(half[1], half[1], TWICE);
        *(OF(lanes) *)(out + k) =
            scale *
            (s * a + (1 - s) * alternate * __builtin_shufflevector(b, b, REVERSED) +
             c * (alternate * __builtin_shufflevector(a, a, SWAPPED) + __builtin_shufflevector(b, b, BACKWARDS)));
    }
}

static void OF(transform_rows)(const struct pass *pass)
{
    const struct direct_kernel *kernel = pass->kernel;
    struct OF(room) *room = kernel->room;
    const size_t half = kernel->nx / 2;
    for (size_t j = 0; j < kernel->ny; j++) {
        const double *row = pass->from + j * kernel->stride;
        FFT(complex) *to = room->field + j * room->stride;
        if (row[0] == 0 && memcmp(row, row + 1, (kernel->nx - 1) * sizeof *row) == 0) { /* all 0, as is its transform */
            memset(to, 0, (half + 1) * sizeof *to);
            continue;
        }
        OF(transform_row)(pass, row);
        if (numbers_of(kernel->nx) == half)
            OF(part_row)(to, room->transformed, half + 1, room->share, half, 1);
        else
            memcpy(to, room->transformed, (half + 1) * sizeof *to);
    }
}

/** The rows that are wanted; NULL: all. */
static void OF(transform_rows_back)(const struct pass *pass)
{
    const struct direct_kernel *kernel = pass->kernel;
    struct OF(room) *room = kernel->room;
    const size_t n = kernel->nx, half = n / 2;
    for (size_t j = 0; j < kernel->ny; j++) {
        const FFT(complex) *from = room->field + j * room->stride;
        if (pass->wanted && !pass->wanted[j])
            continue;
        if (numbers_of(n) == half)
            OF(part_row)(room->multiplied, from, half, room->share, half, -1);
        for (size_t k = 0; k < n && numbers_of(n) == n; k++) {
            room->multiplied[k][0] = from[k <= half ? k : n - k][0];
            room->multiplied[k][1] = (k <= half ? 1 : -1) * from[k <= half ? k : n - k][1];
        }
        OF(transform_row_back)(pass, kernel->field + j * kernel->stride);
    }
}

/** Multiplies a transformed column by its factors, which go up to half of the waves and down again. */
CLONES static void OF(multiply)(FFT(complex) * out, const FFT(complex) * in, const REAL *factor, size_t ny)
{
    for (size_t j = 0; j <= ny / 2; j++) {
        out[j][0] = factor[j] * in[j][0];
        out[j][1] = factor[j] * in[j][1];
    }
    for (size_t j = ny / 2 + 1; j < ny; j++) {
        out[j][0] = factor[ny - j] * in[j][0];
        out[j][1] = factor[ny - j] * in[j][1];
    }
}

/** Multiplies numbers by those of a table, or (`sign` -1) by their conjugates. */
INLINE void OF(turn)(OF(lanes) * value, const REAL *real, const REAL *imaginary, REAL sign)
{
    *value = *value * *(const OF(lanes) *)real +
             sign * __builtin_shufflevector(*value, *value, SWAPPED) * *(const OF(lanes) *)imaginary;
}

/** Column i of a mirrored grid times its factors. Places j and n - j, a and b, hold four cosines: turned to a' = a
 * exp(-i pi (i + j)/(2n)), b' = b exp(i pi (j - i)/(2n)) their parts are sums and differences of (i, j) and (n - i, n -
 * j), and of (i, n - j) and (n - i, j), which with the factors of fill_column() become S a' + D b' and S b' + D a'. The
 * last places are done twice, for the sake of whole lanes. */
CLONES static void OF(multiply_mirrored)(FFT(complex) * out, const FFT(complex) * in, const REAL *factor, size_t i,
                                         const REAL *turn, size_t n)
{
    enum { NUMBERS = LANES / 2 };
    const REAL *imaginary = turn + 2 * (3 * n + 1), *difference = factor + 2 * (n / 2 + 1);
    for (size_t done = 0; done <= n / 2; done += NUMBERS) {
        const size_t j = done + NUMBERS <= n / 2 + 1 ? done : n / 2 + 1 - NUMBERS, last = n - j - (NUMBERS - 1);
        const size_t at = 2 * (n + i + j), back = 2 * (n + j - i);
        const OF(lanes) s = *(const OF(lanes) *)(factor + 2 * j), d = *(const OF(lanes) *)(difference + 2 * j);
        OF(lanes) a = *(const OF(lanes) *)(in + j), b = *(const OF(lanes) *)(in + last), turned[2];
        b = __builtin_shufflevector(b, b, REVERSED);
        OF(turn)(&a, turn + at, imaginary + at, 1);
        OF(turn)(&b, turn + back, imaginary + back, -1);
        turned[0] = s * a + d * b;
        turned[1] = s * b + d * a;
        OF(turn)(&turned[0], turn + at, imaginary + at, -1);
        OF(turn)(&turned[1], turn + back, imaginary + back, 1);
        *(OF(lanes) *)(out + j) = turned[0];
        *(OF(lanes) *)(out + last) = __builtin_shufflevector(turned[1], turned[1], REVERSED);
    }
}

/** Sum of the products of the parts of `count` numbers. */
CLONES static double OF(product)(const FFT(complex) * a, const FFT(complex) * b, size_t count)
{
    const REAL *x = *a, *y = *b;
    double part[LANES] = {0}, sum = 0;
    size_t k = 0;
    for (; k + LANES <= 2 * count; k += LANES)
        for (size_t i = 0; i < LANES; i++)
            part[i] += (double)(x[k + i] * y[k + i]);
    for (; k < 2 * count; k++)
        sum += (double)(x[k] * y[k]);
    for (size_t i = 0; i < LANES; i++)
        sum += part[i];
    return sum;
}

/** Copies columns from `first` on to where each is contiguous; or back. */
static void OF(copy_columns)(struct direct_kernel *kernel, size_t first, bool back)
{
    struct OF(room) *room = kernel->room;
    for (size_t j = 0; j < kernel->ny; j++) {
        FFT(complex) *row = room->field + (kernel->mirrored ? place(j, kernel->ny) : j) * room->stride + first;
        FFT(complex) *out = room->columns + j;
        for (size_t i = 0; i < BLOCK; i++)
            if (back)
                memcpy(row + i, out + i * (kernel->ny + GAP), sizeof *row);
            else
                memcpy(out + i * (kernel->ny + GAP), row + i, sizeof *row);
    }
}

/** All columns, some at a time: transform, times the table, and back; or only their energy. */
static void OF(pass_columns)(struct pass *pass)
{
    struct direct_kernel *kernel = pass->kernel;
    struct OF(room) *room = kernel->room;
    const size_t n = kernel->ny, count = kernel->nx / 2 + 1;
    const REAL *factor = room->table[pass->table];
    for (size_t i = 0; i < count; i++, factor += OF(column_length)(kernel)) {
        FFT(complex) *column = room->columns + i % BLOCK * (n + GAP);
        if (i % BLOCK == 0)
            OF(copy_columns)(kernel, i, false);
        FFT(execute_dft)(room->column_forward, column, room->transformed);
        if (kernel->mirrored) {
            memcpy(room->transformed + n, room->transformed, sizeof *room->transformed);
            OF(multiply_mirrored)(room->multiplied, room->transformed, factor, i, room->turn, n);
        } else {
            OF(multiply)(room->multiplied, room->transformed, factor, n);
        }
        if (pass->filter)
            FFT(execute_dft)(room->column_backward, room->multiplied, column);
        else
            pass->energy += times(kernel, i) * OF(product)(room->transformed, room->multiplied, n);
        if (pass->filter && (i % BLOCK == BLOCK - 1 || i + 1 == count))
            OF(copy_columns)(kernel, i / BLOCK * BLOCK, true);
    }
}

/** Multiplies a strip's transform by its factors. With f and g of X[k] and X[h - k] in part_row(), what the complex
 * numbers become is A Z[k] + i B conj Z[h - k], A = s f + (1 - s) g, B = c (f - g). */
CLONES static void OF(multiply_strip)(FFT(complex) * out, const FFT(complex) * in, const REAL *factor, size_t h)
{
    enum { NUMBERS = LANES / 2 };
    for (size_t done = 0; done < h; done += NUMBERS) {
        const size_t k = done + NUMBERS <= h ? done : h - NUMBERS;
        const OF(lanes) a = *(const OF(lanes) *)(in + k), b = *(const OF(lanes) *)(in + h - k - (NUMBERS - 1));
        const OF(half) half[2] = {*(const OF(half) *)(factor + k), *(const OF(half) *)(factor + h + k)};
        *(OF(lanes) *)(out + k) =
            __builtin_shufflevector(half[0], half[0], TWICE) * a +
            __builtin_shufflevector(half[1], half[1], TWICE) * __builtin_shufflevector(b, b, BACKWARDS);
    }
}

static void OF(pass_strip)(struct pass *pass)
{
    const struct OF(room) *room = pass->kernel->room;
    const size_t numbers = numbers_of(pass->kernel->nx);
    OF(transform_row)(pass, pass->from);
    OF(multiply_strip)(room->multiplied, room->transformed, room->table[pass->table], numbers);
    if (pass->filter)
        OF(transform_row_back)(pass, pass->kernel->field);
    else
        pass->energy = OF(product)(room->transformed, room->multiplied, numbers);
}

static void OF(pass)(struct pass *pass)
{
    const struct OF(room) *room = pass->kernel->room;
    pass->kernel->transforms += pass->filter ? 2 : 1;
    if (pass->kernel->ny == 1) {
        OF(pass_strip)(pass);
    } else {
        OF(transform_rows)(pass);
        OF(pass_columns)(pass);
        if (pass->filter)
            OF(transform_rows_back)(pass);
    }
    pass->energy *= room->after[pass->table] / room->before[pass->table];
}

#undef REAL
#undef OF
#undef FFT
#undef LANES
#undef SWAPPED
#undef REVERSED
#undef TWICE
#undef BACKWARDS
