# Curves against a load, an area or a wavelength.
#   call 'curves.gp' DATA OUTPUT TITLE XLABEL YLABEL LOGARITHMIC STYLES [AXES [UNSURE]]
# LOGARITHMIC: 'xy', 'x', 'y' or ''. STYLES: one word a block of DATA: s1..s8 surfaces, two letters a model (models.gp), r1..r9
# steps of a sweep, labelled at their ends; with `a` its adjusted separation, with `S` what stands in the panel below; with x
# at its end the part of that curve outside its range of validity, with b the interval of the mean around it (rows
# x,low,high; the first two are filled, more are bars), with hLN what of it lies under L of N lines: dashes over them; these
# get no legend entry. meas: measured points, dirl, diro, dirp: directly solved ones (rows x,y,low,high), joined in their
# order. A row whose y is 0 on a logarithmic axis ends its curve at the chart's lower edge. AXES: 'A B C D [E F]': the x axis
# holds A to B, the y axis C to D, that of the panel below E to F.
# UNSURE: left of this x the chart is shaded. below_label, set before: what the panel below shows.
data = ARG1; output = ARG2; title_text = ARG3; x_label = ARG4; y_label = ARG5; logarithmic = ARG6; style_words = ARG7
axes = ARGC > 7 ? ARG8 : ''
unsure = ARGC > 8 ? ARG9 + 0.0 : 0
load 'style.gp'
log_x = strstrt(logarithmic, 'x') > 0
log_y = strstrt(logarithmic, 'y') > 0
load 'blocks.gp'

# NUMBER counts the curves, one for a stem: their letter in text mode, the stagger of their markers otherwise.
array NUMBER[MOST_BLOCKS]
solid = ''; dashed = ''; marked = ''; bands = ''; measured = ''; entries = ''; stems = ' '; numbers = 0
below_solid = ''; below_dashed = ''; covered = ''; ends = ''
do for [i = 1:BLOCKS] {
    w = word(style_words, i)
    if (!known(w)) { exit error sprintf("'%s' is not a style word", w) }
    NUMBER[i] = 0
    do for [j = 1:i - 1] { if (base(word(style_words, j)) eq base(w) && adjusted(word(style_words, j)) == adjusted(w)) { NUMBER[i] = NUMBER[j] } }
    if (NUMBER[i] == 0) { numbers = numbers + 1; NUMBER[i] = numbers }
    if (hidden(w)) { covered = sprintf('%d ', i) . covered; continue }
    if (scaled(w)) {
        if (ROWS[i] > 0 && outside(w)) { below_dashed = below_dashed . sprintf(' %d', i) }
        if (ROWS[i] > 0 && !outside(w)) { below_solid = below_solid . sprintf(' %d', i) }
        continue
    }
    if (ROWS[i] > 1 && band(w)) { bands = bands . sprintf(' %d', i) }
    if (ROWS[i] > 0 && in_bars(w)) { measured = measured . sprintf(' %d', i) }
    if (band(w) || in_bars(w)) { continue }
    if (ROWS[i] > 1 && outside(w)) { dashed = dashed . sprintf(' %d', i) }
    if (ROWS[i] > 1 && !outside(w)) { solid = solid . sprintf(' %d', i) }
    if (ROWS[i] > 0) { stems = stems . stem(w) . ' ' }
}
filled = words(bands) > 2 ? word(bands, 1) . ' ' . word(bands, 2) : bands
bars = ''
do for [k = 3:words(bands)] { bars = bars . ' ' . word(bands, k) }
both = ' ' # models with an adjusted curve: their plain one steps back
do for [i = 1:BLOCKS] { if (adjusted(word(style_words, i))) { both = both . base(word(style_words, i)) . ' ' } }
steps_back(w) = strstrt(both, ' ' . base(w) . ' ') > 0 && !adjusted(w)
width(w) = steps_back(w) ? 0.7 : adjusted(w) ? 2.6 : 2
shape(w) = steps_back(w) ? -1 : marker(w)
size(w) = shape(w) < 0 ? 0.1 : shape(w) % 2 ? 0.75 : 0.9
# As a single point: the marker of the curve, a cross for one that steps back.
alone(w) = steps_back(w) ? (marker(w) % 2 ? 2 : 1) : single(w)
points = ' '
do for [i in in_points] { points = points . stem(word(style_words, int(i))) . ' ' }
is_point(i) = ROWS[i] < 2 && strstrt(points, ' ' . word(style_words, i) . ' ') > 0
key_shape(i) = is_point(i) ? alone(word(style_words, i)) : shape(word(style_words, i))
key_point(i) = is_point(i) ? 0.9 : size(word(style_words, i))
longest = 1; count = 0; label_length = 1
swept = style_words[1:1] eq 'r' && !text_mode # labels at the curves' ends, no legend
do for [i = 1:BLOCKS] {
    w = word(style_words, i)
    LEGEND[i] = short(LEGEND[i], 60)
    if (band(w) || in_bars(w) || hidden(w) || scaled(w)) { continue }
    if (!outside(w) && strstrt(stems, ' ' . w . ' ')) {
        if (swept) { ends = ends . sprintf(' %d', i); label_length = most(label_length, strlen(LEGEND[i])) } else {
            entries = entries . sprintf(' %d', i); count = count + 1; longest = most(longest, strlen(LEGEND[i])) }
    }
    if (ROWS[i] > 1 && !outside(w) && shape(w) > 0) { marked = marked . sprintf(' %d', i) }
}
few = '' # single points outside the range of validity
do for [i in in_points] { if (outside(word(style_words, int(i)))) { few = few . ' ' . i } }
note_outside = strlen(few) ? 'small: outside validity' : 'outside its validity'
note_band = '95 % interval of the mean'
do for [i = 1:BLOCKS] { if (ROWS[i] > 1 && band(word(style_words, i)) && LEGEND[i] ne 'band') { note_band = LEGEND[i] } }
note_bars = 'the same, as bars'
note_covered = 'colours in turn'
if (!text_mode) {
    if (strlen(bands)) { count = count + 1; longest = most(longest, strlen(note_band)) }
    if (strlen(bars)) { count = count + 1 }
    if (strlen(covered)) { count = count + 1; longest = most(longest, strlen(note_covered)) }
}
do for [i = 1:BLOCKS] { if (ROWS[i] > 0 && in_bars(word(style_words, i))) { count = count + 1; longest = most(longest, strlen(LEGEND[i])) } }
if (strlen(dashed . few)) { count = count + 1; longest = most(longest, strlen(note_outside)) }
lower_panel = strlen(below_solid . below_dashed) && !text_mode ? 130 : 0
load 'legend.gp'
cut = 0 # curves leave through the chart's lower edge
if (words(axes) >= 4 && !empty) {
    x_low = least(x_low, word(axes, 1) + 0); x_high = most(x_high, word(axes, 2) + 0)
    cut = y_low < word(axes, 3) * (log_y ? 1 - 1e-5 : 1) - (log_y ? 0 : 1e-5 * (y_high - y_low))
    y_low = word(axes, 3) + 0; y_high = most(y_high, word(axes, 4) + 0)
}
if (lower_panel) { set multiplot }
low = x_low; high = x_high
call 'axis.gp' 'x' (log_x ? 'log' : 'zero') '0' (text_mode ? '6' : '8') (lower_panel ? 'bare' : '')
# Where curves are cut the axis ends there: its room below is taken back.
low = cut && !log_y && y_low < 0 ? (y_low + 0.04 * y_high) / 1.04 : y_low; high = y_high
call 'axis.gp' 'y' (log_y ? 'log' : 'zero') '0.04' (text_mode ? '5' : '7')
if (!log_y && !text_mode) { set xzeroaxis lc rgb quiet lw 0.7 lt 1 }
lowest = log_y && !empty ? 10**low : 0
shown(y) = log_y && y == 0 ? lowest : y
if (lower_panel) {
    set xlabel ''
    set tmargin at screen 1 - 1.0 * top / height
    set bmargin at screen 1 - 1.0 * (top + 340) / height
    set lmargin at screen 0.15
    set rmargin at screen 0.965
}

# Labels at the ends of a sweep's curves, kept apart, each with a stroke to its curve.
if (strlen(ends) && !empty) {
    set rmargin at screen 1 - (34 + 8.2 * label_length) / 680
    array AT[MOST_BLOCKS] # end of a curve on the axis, 0 to 1
    array ORDER[MOST_BLOCKS]
    array LABEL[MOST_BLOCKS]
    n = words(ends)
    do for [k = 1:n] {
        ORDER[k] = int(word(ends, k))
        AT[k] = ((log_y ? log10(Y_END[ORDER[k]]) : Y_END[ORDER[k]]) - low) / (high - low)
        m = k
        while (m > 1 && AT[most(m - 1, 1)] > AT[m]) {
            held = AT[m]; AT[m] = AT[m - 1]; AT[m - 1] = held
            held = ORDER[m]; ORDER[m] = ORDER[m - 1]; ORDER[m - 1] = held
            m = m - 1
        }
    }
    apart = 19.0 / 340
    do for [k = 1:n] { LABEL[k] = k > 1 ? most(AT[k], LABEL[k - 1] + apart) : AT[k] }
    LABEL[n] = least(LABEL[n], 1)
    do for [m = 1:n - 1] { k = n - m; LABEL[k] = least(LABEL[k], LABEL[k + 1] - apart) }
    do for [k = 1:n] {
        i = ORDER[k]
        set arrow from graph 1.005, graph AT[k] to graph 1.035, graph LABEL[k] nohead lw 1.2 lc rgb colour(word(style_words, i))
        set label LEGEND[i] at graph 1.045, graph LABEL[k] left noenhanced textcolor rgb ink
    }
}

if (unsure > x_low && !empty && !text_mode) { set object 1 rectangle from graph 0, graph 0 to first (least(unsure, x_high)), graph 1 behind fc rgb quiet fs transparent solid 0.15 noborder }

# The plot is put together from parts because gnuplot runs a loop over an empty list once. The parts name variables only.
interval(i) = int(most(1, ceil(ROWS[i] / 9.0)))
offset(i) = int(interval(i) * (NUMBER[i] % 4) / 4.0)
hue(i) = colour(word(style_words, i))
# Of what lies under L of N lines, dashes take up N - L parts of N, so that all N show in turn.
covers(w) = int(w[strlen(w) - 1:strlen(w) - 1])
together(w) = int(w[strlen(w):*])
# A few points a curve say their numbers when they are pointed at; names stay out of it, as gnuplot does not escape them there.
unseen(i) = '#ff' . hue(i)[2:7]
spoken(i) = int(most(1, ceil(ROWS[i] / 4.0)))
tip(x, y) = sprintf('%.4g, %.4g', x, y)
command = 'plot NaN notitle'
if (text_mode) {
    if (strlen(solid)) { command = command . \
        ', for [i in solid] data index int(i) - 1 using 1:2 with points pt NUMBER[int(i)] notitle' }
    if (strlen(dashed)) { command = command . \
        ', for [i in dashed] data index int(i) - 1 every 4::1 using 1:2 with points pt NUMBER[int(i)] notitle' }
    if (strlen(in_points)) { command = command . \
        ', for [i in in_points] data index int(i) - 1 using 1:2 with points pt NUMBER[int(i)] notitle' }
    if (strlen(entries)) { command = command . \
        ', for [i in entries] keyentry with points pt NUMBER[int(i)] title LEGEND[int(i)]' }
    if (strlen(measured)) { command = command . \
        ', for [i in measured] data index int(i) - 1 using 1:2 with points pt 15 title LEGEND[int(i)]' }
} else {
    if (strlen(filled)) { command = command . \
        ', for [i in filled] data index int(i) - 1 using 1:2:3 with filledcurves fc rgb hue(int(i)) fs transparent solid 0.2 noborder notitle' }
    if (strlen(dashed)) { command = command . \
        ', for [i in dashed] data index int(i) - 1 using 1:(shown($2)) with lines dt (7,4) lw (steps_back(word(style_words, int(i))) ? 0.7 : 1.3) lc rgb hue(int(i)) notitle' }
    if (strlen(solid)) { command = command . \
        ', for [i in solid] data index int(i) - 1 using 1:(shown($2)) with lines lw width(word(style_words, int(i))) lc rgb hue(int(i)) notitle' }
    do for [i in covered] { w = word(style_words, int(i)); command = command . \
        sprintf(', data index %d using 1:2 with lines lw 2 dt (%d,%d) lc rgb hue(%d) notitle', int(i) - 1, 8 * (together(w) - covers(w)), 8 * covers(w), int(i)) }
    if (strlen(bars)) { command = command . \
        ', for [i in bars] data index int(i) - 1 every interval(int(i))::1 + offset(int(i)) using 1:2:(0):($3 - $2) with vectors nohead lw 1.4 lc rgb hue(int(i)) notitle' }
    if (strlen(marked)) { command = command . \
        ', for [i in marked] data index int(i) - 1 every interval(int(i))::1 + offset(int(i)) using 1:2 with points ' . \
        'pt shape(word(style_words, int(i))) ps size(word(style_words, int(i))) lw 1.3 lc rgb hue(int(i)) notitle' }
    if (strlen(in_points)) { command = command . \
        ', for [i in in_points] data index int(i) - 1 using 1:2 with points pt alone(word(style_words, int(i))) ' . \
        'ps (outside(word(style_words, int(i))) ? 0.6 : 1.1) lw 1.3 lc rgb hue(int(i)) notitle' }
    if (strlen(solid)) { command = command . \
        ', for [i in solid] data index int(i) - 1 every spoken(int(i))::spoken(int(i)) / 2 using 1:2:(tip($1, $2)) ' . \
        'with labels hypertext point pt 11 ps 1.4 lc rgb unseen(int(i)) notitle' }
    if (strlen(in_points . measured)) { command = command . \
        ', for [i in in_points . measured] data index int(i) - 1 every int(most(1, ceil(ROWS[int(i)] / 10.0))) using 1:2:(tip($1, $2)) ' . \
        'with labels hypertext point pt 11 ps 1.4 lc rgb unseen(int(i)) notitle' }
    if (strlen(entries)) { command = command . \
        ', for [i in entries] keyentry with linespoints lw width(word(style_words, int(i))) lc rgb hue(int(i)) ' . \
        'pt key_shape(int(i)) ps key_point(int(i)) title LEGEND[int(i)]' }
    if (strlen(dashed)) { command = command . \
        ', keyentry with lines dt (7,4) lw 1.3 lc rgb quiet title note_outside' } else { if (strlen(few)) { command = command . \
        ', keyentry with points pt 7 ps 0.6 lc rgb quiet title note_outside' } }
    if (strlen(covered)) { command = command . \
        ', keyentry with lines dt (8,8) lw 2 lc rgb ink title note_covered' }
    if (strlen(bands)) { command = command . \
        ', keyentry with boxes fc rgb quiet fs transparent solid 0.3 noborder title note_band' }
    if (strlen(bars)) { command = command . \
        ', keyentry with points pt "|" tc rgb quiet title note_bars' }
    if (strlen(measured)) { command = command . \
        ', for [i in measured] data index int(i) - 1 using 1:2 with lines lw 0.9 lc rgb hue(int(i)) notitle' . \
        ', for [i in measured] data index int(i) - 1 using 1:2:3:4 with yerrorbars pt marker(word(style_words, int(i))) ps 0.9 lw 1.4 lc rgb hue(int(i)) title LEGEND[int(i)]' }
}
eval command

# The panel below: ratios, on the same x axis.
if (lower_panel) {
    unset key
    unset title
    unset label
    set tmargin at screen 1 - (top + 340 + 34.0) / height
    set bmargin at screen 1 - (top + 340.0 + lower_panel) / height
    low = x_low; high = x_high
    call 'axis.gp' 'x' (log_x ? 'log' : 'zero') '0' '8'
    set xlabel axis_label(x_label)
    low = 1; high = 1.01
    do for [i in below_solid . below_dashed] { low = least(low, Y_LOW[int(i)]); high = most(high, Y_HIGH[int(i)]) }
    if (words(axes) >= 6) { low = least(low, word(axes, 5) + 0); high = most(high, word(axes, 6) + 0) }
    unset logscale y
    set ytics autofreq
    wide_range = low > 0 && high > 5 * low
    call 'axis.gp' 'y' (wide_range ? 'log' : 'tight') '0.06' '4'
    unset xzeroaxis
    set ylabel 'ratio'
    if (!exists('below_label')) { below_label = 'scale-dependent / plain' }
    set label 1 below_label at graph 0, graph 1 offset 0, 0.7 left noenhanced textcolor rgb ink
    command = 'plot 1 lt 1 lw 0.7 lc rgb quiet notitle'
    if (strlen(below_dashed)) { command = command . \
        ', for [i in below_dashed] data index int(i) - 1 using 1:2 with lines dt (7,4) lw 1.3 lc rgb hue(int(i)) notitle' }
    if (strlen(below_solid)) { command = command . \
        ', for [i in below_solid] data index int(i) - 1 using 1:2 with lines lw 2 lc rgb hue(int(i)) notitle' . \
        ', for [i in below_solid] data index int(i) - 1 every interval(int(i))::1 + offset(int(i)) using 1:2 with points ' . \
        'pt marker(word(style_words, int(i))) ps (marker(word(style_words, int(i))) < 0 ? 0.1 : 0.75) lw 1.3 lc rgb hue(int(i)) notitle' }
    eval command
    unset multiplot
}
set output
