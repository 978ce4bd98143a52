/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spectrum/power_law_band.h"

#include "spectrum/multitaper.h"
#include "spectrum/spectrum.h"
#include <assert.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sort_double.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

const char *const power_law_band_class_names[] = {"no power law found", "scattered", "narrow", "law"};

static const double one_law_square = 0.05 * 0.05; /* decades²: a smaller misfit does not divide one power law */
static const double piece_penalty = 4;            /* times ln J for each piece */
/* Below least_gamma: a plateau or noise. Above most_gamma: the flank of a filter. It is above 2.2, as half of all laws
 * of 2.2 are found steeper. */
static const double least_gamma = 0.5, most_gamma = 2.28;
static const double steep_gamma = 1.75; /* above it, waves longer than the record leak into the first harmonics */
static const double least_width_decades = 0.5, law_width_decades = 1, most_misfit_decades = 0.1;
static const double line_decades = 0.2, line_valley_decades = 0.3;
static const double line_level = 0.02;      /* share of files without lines in which one may be found */
static const double line_side_level = 0.05; /* the same of the bins on one side only */
static const double line_scatter = 2;       /* variance of a bin of log-normal amplitudes over that of a Gaussian one */
static const double most_gamma_s = 0.35;    /* a narrow law with a larger error says less than a scattered line */
static const double scattered_variance = 7.5; /* the same as line_scatter, amplitudes scattering by 0.4 decades */
static const double knee_gamma_s = 0.04, knee_amplitude_s_decades = 0.02;
enum { PIECE_BINS = 3, CANDIDATE_BINS = 4, KNEE_BINS = 2, LINE_RUN = 3 };

/** Numbers of the bins that take part, from long to short waves. */
struct selection {
    const struct log_bin *all;
    double scatter; /* variance of a bin over that on a Gaussian surface */
    size_t count;
    size_t index[LOG_BIN_MOST];
};

static const struct log_bin *bin_at(const struct selection *selection, size_t i)
{
    return &selection->all[selection->index[i]];
}

static struct selection part_of(const struct selection *selection, size_t first, size_t count)
{
    struct selection part = {.all = selection->all, .scatter = selection->scatter, .count = count};
    memcpy(part.index, selection->index + first, count * sizeof *part.index);
    return part;
}

/** Weighted straight line y = y_mean + slope (x - x_mean), w = 1/(v + misfit²). */
struct line {
    double slope, x_mean, y_mean;
    double weight, x_spread;     /* sum w, sum w (x - x_mean)² */
    double residual, derivative; /* sum w r²; sum w² r²: how fast it falls with misfit² while the line stays */
};

static double weight_of(const struct selection *selection, size_t i, double misfit_square)
{
    return 1 / (selection->scatter * bin_at(selection, i)->variance + misfit_square);
}

static struct line line_through(const struct selection *selection, size_t first, size_t last, double misfit_square)
{
    struct line line = {0};
    double x = 0, y = 0, xy = 0;
    for (size_t i = first; i <= last; i++) {
        double w = weight_of(selection, i, misfit_square);
        line.weight += w;
        x += w * bin_at(selection, i)->x;
        y += w * bin_at(selection, i)->y;
    }
    line.x_mean = x / line.weight;
    line.y_mean = y / line.weight;
    for (size_t i = first; i <= last; i++) {
        const struct log_bin *bin = bin_at(selection, i);
        double w = weight_of(selection, i, misfit_square), dx = bin->x - line.x_mean;
        line.x_spread += w * dx * dx;
        xy += w * dx * (bin->y - line.y_mean);
    }
    line.slope = xy / line.x_spread;
    for (size_t i = first; i <= last; i++) {
        const struct log_bin *bin = bin_at(selection, i);
        double w = weight_of(selection, i, misfit_square);
        double r = bin->y - line.y_mean - line.slope * (bin->x - line.x_mean);
        line.residual += w * r * r;
        line.derivative += w * w * r * r;
    }
    return line;
}

/** tau² >= 0 at which sum w r² = n - 2. The sum is convex and falls with tau², so Newton's steps from 0 only rise. */
static double misfit_square_of(const struct selection *selection)
{
    enum { STEPS = 100 };
    double square = 0, step = INFINITY;
    for (int i = 0; i < STEPS && step > 1e-15 * square; i++) {
        struct line line = line_through(selection, 0, selection->count - 1, square);
        step = fmax(0, (line.residual - (double)(selection->count - 2)) / line.derivative);
        square += step;
    }
    return square;
}

/** f'(scatter Sigma + tau² I) f */
static double variance_of(const double *factor, const struct selection *selection, double scans, double misfit_square)
{
    double sum = 0;
    for (size_t i = 0; i < selection->count; i++) {
        sum += factor[i] * factor[i] * (selection->scatter * bin_at(selection, i)->variance + misfit_square);
        for (size_t j = 0; j < i; j++)
            sum += 2 * factor[i] * factor[j] * selection->scatter *
                   log_bin_covariance(bin_at(selection, i), bin_at(selection, j), scans);
    }
    return sum;
}

static struct power_law_band_fit fit_of(const struct selection *selection, double length_m, double scans)
{
    double misfit_square = misfit_square_of(selection);
    struct line line = line_through(selection, 0, selection->count - 1, misfit_square);
    size_t last = bin_at(selection, selection->count - 1)->last, first = bin_at(selection, 0)->first;
    double shortest = log10(length_m / (double)last), longest = log10(length_m / (double)first);
    double middle = (shortest + longest) / 2;
    double slope_factor[LOG_BIN_MOST], amplitude_factor[LOG_BIN_MOST], slope_square = 0, amplitude_square = 0;
    for (size_t i = 0; i < selection->count; i++) {
        double w = weight_of(selection, i, misfit_square);
        slope_factor[i] = w * (bin_at(selection, i)->x - line.x_mean) / line.x_spread;
        amplitude_factor[i] = w / line.weight + slope_factor[i] * (middle - line.x_mean);
        slope_square += slope_factor[i] * slope_factor[i];
        amplitude_square += amplitude_factor[i] * amplitude_factor[i];
    }
    return (struct power_law_band_fit){
        .gamma = line.slope,
        .gamma_bias_s = sqrt(misfit_square * slope_square),
        .log10_amplitude_bias_s = sqrt(misfit_square * amplitude_square),
        .gamma_s = sqrt(variance_of(slope_factor, selection, scans, misfit_square)),
        .log10_amplitude = line.y_mean + line.slope * (middle - line.x_mean),
        .log10_amplitude_s = sqrt(variance_of(amplitude_factor, selection, scans, misfit_square)),
        .wavelength_m = pow(10, middle),
        .misfit_decades = sqrt(misfit_square),
        .band_m = {length_m / (double)last, length_m / (double)first},
        .first_harmonic = first,
        .last_harmonic = last,
    };
}

/** Bins first ... end - 1 of a selection. */
struct span {
    size_t first, end;
};

/** Straight pieces of a selection: piece k has bins first[k] ... first[k+1]-1. */
struct pieces {
    size_t count;
    size_t first[POWER_LAW_BAND_PIECES + 1];
};

static struct span piece_at(const struct pieces *pieces, size_t k)
{
    return (struct span){pieces->first[k], pieces->first[k + 1]};
}

/** Slope of the line through bins first ... last. */
static double slope_of(const struct selection *selection, size_t first, size_t last)
{
    return line_through(selection, first, last, one_law_square).slope;
}

/** Finds the pieces by dynamic programming: least cost of k pieces of bins 0 ... end - 1, and where the last begins. */
static struct pieces divide(const struct selection *selection)
{
    enum { PIECES = POWER_LAW_BAND_PIECES };
    double least[PIECES + 1][LOG_BIN_MOST + 1], penalty = piece_penalty * log((double)selection->count);
    size_t begin[PIECES + 1][LOG_BIN_MOST + 1] = {{0}}, best = 1;
    for (size_t k = 0; k <= PIECES; k++)
        for (size_t end = 0; end <= selection->count; end++)
            least[k][end] = k == 0 && end == 0 ? 0 : INFINITY;
    for (size_t end = PIECE_BINS; end <= selection->count; end++)
        for (size_t first = 0; first + PIECE_BINS <= end; first++) {
            double cost = line_through(selection, first, end - 1, one_law_square).residual;
            for (size_t k = 1; k <= PIECES; k++)
                if (least[k - 1][first] + cost < least[k][end]) {
                    least[k][end] = least[k - 1][first] + cost;
                    begin[k][end] = first;
                }
        }
    for (size_t k = 2; k <= PIECES; k++)
        if (least[k][selection->count] + (double)(k - 1) * penalty <
            least[best][selection->count] + (double)(best - 1) * penalty)
            best = k;
    struct pieces pieces = {.count = best};
    pieces.first[best] = selection->count;
    for (size_t k = best; k > 0; k--)
        pieces.first[k - 1] = begin[k][pieces.first[k]];
    return pieces;
}

/** Does bin j stand above the middle of its neighbours? So does a line, and so does the last bin before a cut-off. */
static bool stands_out(const struct power_law_band *band, size_t j, double z)
{
    double between[3];
    size_t count = 0;
    for (size_t m = 2; m <= 4; m++)
        if (j >= m && j + m < band->bins && isfinite(band->bin[j - m].y) && isfinite(band->bin[j + m].y))
            between[count++] = (band->bin[j - m].y + band->bin[j + m].y) / 2;
    if (count < 2 || !isfinite(band->bin[j].y))
        return false;
    gsl_sort(between, 1, count);
    double threshold = fmax(line_decades, z * sqrt(line_scatter * band->bin[j].variance));
    return band->bin[j].y - gsl_stats_median_from_sorted_data(between, 1, count) > threshold;
}

/** Marks the runs of bins that stand `out` and hold a line, and the bin on either side, into which the tapers carry it.
 * Longer runs are knees. */
static void mark_lines(struct power_law_band *band, const bool out[LOG_BIN_MOST], const bool line[LOG_BIN_MOST])
{
    for (size_t j = 0; j < band->bins; j++)
        band->use[j] = isfinite(band->bin[j].y) ? POWER_LAW_BAND_OUTSIDE : POWER_LAW_BAND_EMPTY;
    for (size_t j = 0, end; j < band->bins; j = j < end ? end : j + 1) {
        bool lines = false;
        for (end = j; end < band->bins && out[end]; end++)
            lines = lines || line[end];
        if (!lines || end - j > LINE_RUN)
            continue;
        for (size_t i = j > 0 ? j - 1 : 0; i <= end && i < band->bins; i++)
            if (band->use[i] != POWER_LAW_BAND_EMPTY)
                band->use[i] = i >= j && i < end ? POWER_LAW_BAND_LINE : POWER_LAW_BAND_BESIDE;
    }
}

static struct selection bins_outside(const struct power_law_band *band)
{
    struct selection selection = {.all = band->bin, .scatter = 1};
    for (size_t j = 0; j < band->bins; j++)
        if (band->use[j] == POWER_LAW_BAND_OUTSIDE)
            selection.index[selection.count++] = j;
    return selection;
}

/** Does the highest harmonic of a bin stand so far above the straight line through other bins that chance does it with
 * a probability of `level` at most? Errors counted: of a harmonic, of the line, and what still passes for one law.
 * Where there are too few bins for a piece, or their line is steeper than any law (the flank of a cut-off or of another
 * spectral line), their mean is taken. */
static bool stands_above(const struct selection *selection, struct span others, const struct log_bin *bin, double scans,
                         double level)
{
    if (others.end == others.first)
        return false;
    struct line line = line_through(selection, others.first, others.end - 1, one_law_square);
    double variance = log_bin_variance(scans) + one_law_square + 1 / line.weight;
    double away = bin->peak_x - line.x_mean, excess = bin->peak_y - line.y_mean;
    if (others.end - others.first >= PIECE_BINS && line.slope <= most_gamma) {
        variance += away * away / line.x_spread;
        excess -= line.slope * away;
    }
    return excess > gsl_cdf_ugaussian_Qinv(level) * sqrt(variance);
}

/** Is bin j a line? `rest` are the bins that are none, and their piece k begins before it. Beside a cut-off, too, bins
 * stand above the middle of their neighbours; but right of a line there is a valley, deeper than any law falls, and the
 * line stands above the law of its piece, of the bins on its left and of those on its right. Where the piece has too
 * few bins on a side, the next piece stands in, on the right else the whole piece. A piece steeper than any law tells
 * nothing; then either side must tell alone. */
static bool is_line(const struct power_law_band *band, const struct selection *rest, const struct pieces *pieces,
                    size_t k, size_t j, double scans)
{
    const struct log_bin *bin = &band->bin[j];
    const struct span piece = piece_at(pieces, k);
    size_t here = piece.first, after = j;
    while (here < piece.end && rest->index[here] < j)
        here++;
    while (after + 1 < band->bins && band->use[after] == POWER_LAW_BAND_LINE)
        after++;
    struct span left = {piece.first, here}, right = {here, piece.end};
    if (here - piece.first < PIECE_BINS && k > 0)
        left = piece_at(pieces, k - 1);
    if (piece.end - here < PIECE_BINS)
        right = k + 1 < pieces->count ? piece_at(pieces, k + 1) : piece;
    double valley = bin->peak_y - band->bin[after].y, run = bin->peak_x - band->bin[after].x;
    double level = line_level / (double)band->bin[band->bins - 1].last; /* of one harmonic in the whole file */
    bool flank = slope_of(rest, piece.first, piece.end - 1) > most_gamma;
    double side_level = flank ? level : line_side_level / (double)(bin->last + 1 - bin->first);
    return valley > line_valley_decades + most_gamma * run && stands_above(rest, piece, bin, scans, level) &&
           stands_above(rest, left, bin, scans, side_level) && stands_above(rest, right, bin, scans, side_level);
}

/** Marks the lines: runs of bins that stand out and hold one that also stands above the straight pieces of the rest. */
static void find_lines(struct power_law_band *band, double scans)
{
    bool out[LOG_BIN_MOST] = {false}, line[LOG_BIN_MOST] = {false};
    double z = gsl_cdf_ugaussian_Qinv(line_level / fmax(1, (double)band->bins));
    for (size_t j = 0; j < band->bins; j++)
        out[j] = stands_out(band, j, z);
    for (size_t j = 1; j + 1 < band->bins; j++) /* between two that do, without a valley */
        out[j] = out[j] || (out[j - 1] && out[j + 1] &&
                            band->bin[j].y > fmin(band->bin[j - 1].y, band->bin[j + 1].y) - line_decades);
    mark_lines(band, out, out);
    struct selection rest = bins_outside(band);
    if (rest.count < band->bins && rest.count >= (size_t)2 * PIECE_BINS) {
        const struct pieces pieces = divide(&rest);
        for (size_t j = 0, k = 0; j < band->bins; j++) {
            while (k + 1 < pieces.count && rest.index[pieces.first[k + 1]] <= j)
                k++;
            line[j] = band->use[j] == POWER_LAW_BAND_LINE && is_line(band, &rest, &pieces, k, j, scans);
        }
    }
    mark_lines(band, out, line);
}

/** Fills the bins and says which of them may take part. */
static struct selection gather(struct power_law_band *band, const struct power_law_band_spectrum *spectrum,
                               const size_t split[2])
{
    assert(spectrum->scans >= 1 && spectrum->length_m > 0);
    *band = (struct power_law_band){
        .fit = {NAN, NAN, NAN, NAN, 0, 0, NAN, NAN, {NAN, NAN}, 0, 0}, .psd_m3 = NAN, .slope_share = NAN};
    band->bins =
        log_bin_fill(band->bin, spectrum->amplitude_m, spectrum->count, spectrum->length_m, spectrum->scans, split);
    find_lines(band, spectrum->scans);
    for (size_t j = 0; j < band->bins; j++)
        if (spectrum->shortest_m > 0 && band->bin[j].x < log10(spectrum->shortest_m) &&
            band->use[j] == POWER_LAW_BAND_OUTSIDE)
            band->use[j] = POWER_LAW_BAND_SHORT;
    return bins_outside(band);
}

/** sum (2 pi f)² Delta²/2 in the band over that of all harmonics. */
static double slope_share(const struct power_law_band_spectrum *spectrum, const struct power_law_band_fit *fit)
{
    double inside = 0, all = 0;
    for (size_t n = 1; n <= spectrum->count; n++) {
        double part = (double)n * (double)n * (spectrum->amplitude_m[n - 1] * spectrum->amplitude_m[n - 1]);
        all += part;
        inside += n >= fit->first_harmonic && n <= fit->last_harmonic ? part : 0;
    }
    return inside / all;
}

/** Takes the fit through `used`, and what follows from it. */
static void conclude(struct power_law_band *band, const struct power_law_band_fit *fit, const struct selection *used,
                     const struct power_law_band_spectrum *spectrum)
{
    band->fit = *fit;
    band->law = log10((double)fit->last_harmonic / (double)fit->first_harmonic) >= law_width_decades
                    ? POWER_LAW_BAND_LAW
                    : POWER_LAW_BAND_NARROW;
    double amplitude_m = pow(10, fit->log10_amplitude);
    band->psd_m3 = amplitude_m * amplitude_m * spectrum->length_m / 2;
    band->slope_share = slope_share(spectrum, fit);
    for (size_t j = 0; j < band->bins; j++) /* those of a narrow law that is given up */
        band->use[j] = band->use[j] == POWER_LAW_BAND_USED ? POWER_LAW_BAND_OUTSIDE : band->use[j];
    for (size_t i = 0; i < used->count; i++)
        band->use[used->index[i]] = POWER_LAW_BAND_USED;
}

/** A piece without the bins beside its knees. */
struct candidate {
    size_t first, last;
    bool knee[2]; /* at the long, at the short end */
    double width_decades;
};

/** Shortens piece k at its knees by 2, 1 or no bins, as many as leave enough; by 1 at most where the bins scatter. The
 * long end of a steep piece that does not scatter counts as a knee. */
static bool candidate_of(struct candidate *out, const struct selection *selection, const struct pieces *pieces,
                         size_t k)
{
    const struct span piece = piece_at(pieces, k);
    bool scattered = selection->scatter > 1;
    bool steep = !scattered && slope_of(selection, piece.first, piece.end - 1) > steep_gamma;
    *out = (struct candidate){.knee = {k > 0 || steep, k + 1 < pieces->count}};
    for (size_t trim = scattered ? 2 : KNEE_BINS + 1; trim-- > 0;) {
        size_t first = piece.first + (out->knee[0] ? trim : 0), end = piece.end - (out->knee[1] ? trim : 0);
        if (end < first + CANDIDATE_BINS)
            continue;
        out->first = first;
        out->last = end - 1;
        out->width_decades =
            log10((double)bin_at(selection, out->last)->last / (double)bin_at(selection, first)->first);
        if (out->width_decades >= least_width_decades) {
            double gamma = slope_of(selection, out->first, out->last);
            return gamma >= least_gamma && gamma <= most_gamma;
        }
    }
    return false;
}

/** Adds, in quadrature, by how much the fit changes when 2 more bins are left out beside each knee. */
static void add_knee_errors(struct power_law_band_fit *fit, const struct selection *selection,
                            const struct candidate *candidate, const struct power_law_band_spectrum *spectrum)
{
    struct power_law_band_fit whole = *fit;
    double gamma_s = 0, amplitude_s = 0;
    size_t bins = candidate->last - candidate->first + 1;
    for (size_t side = 0; side < 2; side++) {
        if (!candidate->knee[side] || bins < CANDIDATE_BINS + KNEE_BINS)
            continue;
        struct selection part = part_of(selection, candidate->first + (side == 0 ? KNEE_BINS : 0), bins - KNEE_BINS);
        struct power_law_band_fit shorter = fit_of(&part, spectrum->length_m, spectrum->scans);
        double away = log10(whole.wavelength_m) - log10(shorter.wavelength_m);
        gamma_s = hypot(gamma_s, shorter.gamma - whole.gamma);
        amplitude_s = hypot(amplitude_s, shorter.log10_amplitude + shorter.gamma * away - whole.log10_amplitude);
    }
    if (candidate->knee[0] || candidate->knee[1]) {
        gamma_s = hypot(gamma_s, knee_gamma_s);
        amplitude_s = hypot(amplitude_s, knee_amplitude_s_decades);
    }
    fit->gamma_s = hypot(fit->gamma_s, gamma_s);
    fit->gamma_bias_s = hypot(fit->gamma_bias_s, gamma_s);
    fit->log10_amplitude_s = hypot(fit->log10_amplitude_s, amplitude_s);
    fit->log10_amplitude_bias_s = hypot(fit->log10_amplitude_bias_s, amplitude_s);
}

static void tell_knees(struct power_law_band *band, const struct selection *selection, const struct pieces *pieces)
{
    band->pieces = pieces->count;
    for (size_t k = 1; k < pieces->count; k++) {
        size_t first = pieces->first[k];
        band->knee_m[k - 1] = pow(10, (bin_at(selection, first - 1)->x + bin_at(selection, first)->x) / 2);
    }
}

/** Takes the widest candidate that is one law; with selection->scatter above 1, as a scattered one, and only if it
 * holds the middle of the narrow law that was found. */
static void look(struct power_law_band *out, const struct selection *selection,
                 const struct power_law_band_spectrum *spectrum)
{
    const struct pieces pieces = divide(selection);
    const bool scattered = selection->scatter > 1;
    const double middle = log10(out->fit.wavelength_m);
    double widest = 0;
    if (!scattered)
        tell_knees(out, selection, &pieces);
    for (size_t k = 0; k < pieces.count; k++) {
        struct candidate candidate;
        if (!candidate_of(&candidate, selection, &pieces, k) || candidate.width_decades <= widest)
            continue;
        struct selection used = part_of(selection, candidate.first, candidate.last - candidate.first + 1);
        if (scattered) {
            if (middle < bin_at(&used, used.count - 1)->x || middle > bin_at(&used, 0)->x)
                continue;
            used.scatter = 1;
            used.scatter = fmax(1, line_through(&used, 0, used.count - 1, 0).residual / (double)(used.count - 2));
        }
        struct power_law_band_fit fit = fit_of(&used, spectrum->length_m, spectrum->scans);
        if (!scattered) {
            if (fit.misfit_decades > most_misfit_decades)
                continue;
            add_knee_errors(&fit, selection, &candidate, spectrum);
        }
        widest = candidate.width_decades;
        conclude(out, &fit, &used, spectrum);
        if (scattered) {
            out->law = POWER_LAW_BAND_SCATTERED;
            if (used.index[0] == 0) /* no knee: as long as the scan */
                out->fit.band_m[1] = spectrum->length_m;
        }
    }
}

void power_law_band_find(struct power_law_band *out, const struct power_law_band_spectrum *spectrum)
{
    struct selection selection = gather(out, spectrum, NULL);
    if (selection.count < (size_t)2 * PIECE_BINS)
        return;
    look(out, &selection, spectrum);
    if (out->law == POWER_LAW_BAND_LAW || out->fit.gamma_s <= most_gamma_s)
        return;
    selection.scatter = scattered_variance;
    look(out, &selection, spectrum);
}

void power_law_band_fit_in(struct power_law_band *out, const struct power_law_band_spectrum *spectrum,
                           const double band_m[2])
{
    assert(band_m[0] >= 0 && band_m[1] > band_m[0]);
    const double rounding = 1e-9; /* so that a band that ends on a harmonic includes it */
    double most = (double)spectrum->count;
    double first = ceil(fmin(spectrum->length_m / band_m[1] * (1 - rounding), most + 1));
    double last = floor(fmin(spectrum->length_m / band_m[0] * (1 + rounding), most));
    size_t split[2] = {first > 1 ? (size_t)first : 1, (size_t)last};
    struct selection selection = gather(out, spectrum, split), used = {.all = selection.all, .scatter = 1};
    for (size_t i = 0; i < selection.count; i++)
        if (bin_at(&selection, i)->first >= split[0] && bin_at(&selection, i)->last <= split[1])
            used.index[used.count++] = selection.index[i];
    if (used.count < CANDIDATE_BINS)
        return;
    struct power_law_band_fit fit = fit_of(&used, spectrum->length_m, spectrum->scans);
    conclude(out, &fit, &used, spectrum);
}

size_t power_law_band_lines(double wavelength_m[LOG_BIN_MOST], const struct power_law_band *band)
{
    size_t count = 0;
    for (size_t j = 0; j < band->bins; j++) {
        size_t highest = j;
        if (band->use[j] != POWER_LAW_BAND_LINE)
            continue;
        for (; j + 1 < band->bins && band->use[j + 1] == POWER_LAW_BAND_LINE; j++)
            highest = band->bin[j + 1].y > band->bin[highest].y ? j + 1 : highest;
        wavelength_m[count++] = pow(10, band->bin[highest].x);
    }
    return count;
}
