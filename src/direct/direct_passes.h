/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The transforms of direct_kernel.c, which includes this once for each precision: REAL is the type of a value, OF(name)
 * a name here, FFT(name) one of FFTW's, LANES how many values fill 32 bytes, SWAPPED the order that exchanges the parts
 * of complex numbers, REVERSED that which reverses the numbers. Fields are double in both precisions: a row is
 * converted when it is laid out for its transform. In single precision lengths are in units of the spacing, so that no
 * value leaves its range. */

typedef REAL OF(lanes) __attribute__((vector_size(32), aligned(sizeof(REAL)), may_alias));

/** Plans of rows, kept: planning a length again takes 4 % of a short strip's time. */
static struct OF(row_plans) {
    size_t nx;
    FFT(plan) forward, backward;
} OF(kept)[KEPT];

/** Room, plans and tables. */
struct OF(room) {
    size_t stride;                           /* complex numbers from row to row: whole blocks of columns */
    REAL *line;                              /* one row in the order of its transform */
    FFT(complex) * field;                    /* the rows' transforms */
    FFT(complex) * columns;                  /* some of them */
    FFT(complex) * transformed, *multiplied; /* one's transform, and that times its factors; mirrored, [n] is [0] */
    REAL *turn;                              /* of a mirrored grid: fill_turn() */
    REAL *table[DIRECT_TABLES];              /* a column for each wave along x: fill_column() */
    double before[DIRECT_TABLES], after[DIRECT_TABLES]; /* factors of a field as it comes in and goes out */
    struct OF(row_plans) row;
    bool kept; /* the plans of its rows are others' too */
    FFT(plan) column_forward, column_backward;
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

/** Factors of column i; of a mirrored grid those of multiply_mirrored(): all S, then all D, for both parts; of a strip
 * those of pass_row(), for both parts. */
static void OF(fill_column)(const struct direct_kernel *kernel, enum direct_table table, REAL *out, size_t i)
{
    const size_t n = kernel->ny, half = n / 2 + 1;
    if (n == 1) {
        out[0] = (REAL)OF(factor)(kernel, table, i, 0);
        out[1] = out[0];
        return;
    }
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
    return kernel->ny == 1 ? 2 : (kernel->ny / 2 + 1) * (kernel->mirrored ? 4 : 1);
}

static void OF(make_plans)(void *context)
{
    struct direct_kernel *kernel = context;
    struct OF(room) *room = kernel->room;
    int nx = (int)kernel->nx, ny = (int)kernel->ny;
    size_t k = 0;
    while (k < KEPT && OF(kept)[k].nx > 0 && OF(kept)[k].nx != kernel->nx)
        k++;
    room->kept = k < KEPT;
    room->row = room->kept ? OF(kept)[k] : (struct OF(row_plans)){0};
    if (room->row.nx == 0)
        room->row = (struct OF(row_plans)){kernel->nx, FFT(plan_dft_r2c_1d)(nx, room->line, room->field, FFTW_ESTIMATE),
                                           FFT(plan_dft_c2r_1d)(nx, room->field, room->line, FFTW_ESTIMATE)};
    if (room->kept)
        OF(kept)[k] = room->row;
    if (ny == 1)
        return;
    room->column_forward = FFT(plan_dft_1d)(ny, room->columns, room->transformed, FFTW_FORWARD, FFTW_ESTIMATE);
    room->column_backward = FFT(plan_dft_1d)(ny, room->multiplied, room->columns, FFTW_BACKWARD, FFTW_ESTIMATE);
}

static void OF(destroy_plans)(void *context)
{
    struct OF(room) *room = context;
    if (!room->kept) {
        FFT(destroy_plan)(room->row.forward);
        FFT(destroy_plan)(room->row.backward);
    }
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
    for (int k = 0; k < DIRECT_TABLES; k++)
        free(room->table[k]);
    free(room);
}

/** False: out of memory. */
static bool OF(make)(struct direct_kernel *kernel)
{
    struct OF(room) *room = kernel->room = calloc(1, sizeof *room);
    const size_t nx = kernel->nx, ny = kernel->ny, length = OF(column_length)(kernel);
    if (!room)
        return false;
    room->stride = (nx / 2 + BLOCK) / BLOCK * BLOCK;
    room->line = FFT(alloc_real)(nx);
    room->field = FFT(alloc_complex)(ny * room->stride);
    room->columns = FFT(alloc_complex)(BLOCK * (ny + GAP));
    room->transformed = FFT(alloc_complex)(ny + 1);
    room->multiplied = FFT(alloc_complex)(ny + 1);
    room->turn = malloc(kernel->mirrored ? 4 * (3 * nx + 1) * sizeof(REAL) : 1);
    for (int k = 0; k < DIRECT_TABLES; k++)
        room->table[k] = calloc((nx / 2 + BLOCK) * length, sizeof(REAL));
    if (!room->line || !room->field || !room->columns || !room->transformed || !room->multiplied || !room->turn ||
        !room->table[0] || !room->table[1])
        return false;
    memset(room->field, 0, ny * room->stride * sizeof *room->field);
    room->before[DIRECT_COMPLIANCE] = room->after[DIRECT_STIFFNESS] = 1;
    room->after[DIRECT_COMPLIANCE] = kernel->single ? kernel->spacing_m : 1;
    room->before[DIRECT_STIFFNESS] = 1 / room->after[DIRECT_COMPLIANCE];
    fft_plan(OF(make_plans), kernel);
    if (kernel->mirrored)
        OF(fill_turn)(room->turn, nx);
    for (enum direct_table table = 0; table < DIRECT_TABLES; table++)
        for (size_t i = 0; i <= nx / 2; i++)
            OF(fill_column)(kernel, table, room->table[table] + i * length, i);
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

static void OF(transform_rows)(const struct pass *pass)
{
    const struct direct_kernel *kernel = pass->kernel;
    struct OF(room) *room = kernel->room;
    for (size_t j = 0; j < kernel->ny; j++) {
        const double *row = pass->from + j * kernel->stride;
        FFT(complex) *to = room->field + j * room->stride;
        if (row[0] == 0 && memcmp(row, row + 1, (kernel->nx - 1) * sizeof *row) == 0) { /* all 0, as is its transform */
            memset(to, 0, (kernel->nx / 2 + 1) * sizeof *to);
            continue;
        }
        OF(lay_out)(room->line, row, kernel->nx, kernel->mirrored, room->before[pass->table]);
        FFT(execute_dft_r2c)(room->row.forward, room->line, to);
    }
}

/** The rows that are wanted; NULL: all. */
static void OF(transform_rows_back)(const struct pass *pass)
{
    const struct direct_kernel *kernel = pass->kernel;
    struct OF(room) *room = kernel->room;
    const double after = room->after[pass->table];
    for (size_t j = 0; j < kernel->ny; j++) {
        double *row = kernel->field + j * kernel->stride;
        if (pass->wanted && !pass->wanted[j])
            continue;
        FFT(execute_dft_c2r)(room->row.backward, room->field + j * room->stride, room->line);
        OF(take_back)(row, room->line, kernel->nx, kernel->mirrored, after);
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

/** The same of a strip, which has no columns: waves by whole lanes, the last ones filled up with zeros. */
CLONES static void OF(pass_row)(struct pass *pass)
{
    enum { SUM = 256 }; /* values summed before they join a double */
    const struct direct_kernel *kernel = pass->kernel;
    const struct OF(room) *room = kernel->room;
    const size_t n = kernel->nx, values = 2 * (n / 2 + 1);
    const REAL *table = room->table[pass->table];
    const double last =
        n % 2 ? 0 : (double)table[n] * (pow((double)room->field[n / 2][0], 2) + pow((double)room->field[n / 2][1], 2));
    OF(lanes) sums = {0};
    for (size_t k = 0; k < values; k += LANES) {
        OF(lanes) *at = (OF(lanes) *)((REAL *)room->field + k), out = *at * *(const OF(lanes) *)(table + k);
        sums += *at * out;
        *at = out;
        for (size_t i = 0; i < LANES && (k % SUM == 0 || k + LANES >= values); i++) {
            pass->energy += 2 * (double)sums[i];
            sums[i] = 0;
        }
    }
    pass->energy -= last; /* there is one of it, as of the mean, which has no factor */
}

static void OF(pass)(struct pass *pass)
{
    const struct OF(room) *room = pass->kernel->room;
    pass->kernel->transforms += pass->filter ? 2 : 1;
    OF(transform_rows)(pass);
    if (pass->kernel->ny == 1)
        OF(pass_row)(pass);
    else
        OF(pass_columns)(pass);
    if (pass->filter)
        OF(transform_rows_back)(pass);
    pass->energy *= room->after[pass->table] / room->before[pass->table];
}

#undef REAL
#undef OF
#undef FFT
#undef LANES
#undef SWAPPED
#undef REVERSED
