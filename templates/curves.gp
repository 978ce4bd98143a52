# Curves against a load, an area or a wavelength.
#   call 'curves.gp' DATA OUTPUT TITLE XLABEL YLABEL LOGARITHMIC STYLES [AXES [UNSURE]]
# LOGARITHMIC: 'xy', 'x', 'y' or ''. STYLES: one word a block of DATA: s1..s8 surfaces, two letters a model (models.gp), with `a` its
# adjusted separation, with `S` scale-dependent, r1..r9 steps of a sweep; with x at its end the part of that curve outside
# its range of validity, with b the interval of the mean around it (rows x,low,high); these get no legend entry. meas:
# measured points (rows x,y,low,high), joined in their order. AXES: 'A B C': the x axis holds at least A to B; the y axis ends a
# little below C when the data go further down (0: it does not).
# UNSURE: left of this x the chart is shaded.
data = ARG1; output = ARG2; title_text = ARG3; x_label = ARG4; y_label = ARG5; logarithmic = ARG6; style_words = ARG7
axes = ARGC > 7 ? ARG8 : ''
unsure = ARGC > 8 ? ARG9 + 0.0 : 0
load 'style.gp'
log_x = strstrt(logarithmic, 'x') > 0
log_y = strstrt(logarithmic, 'y') > 0
load 'blocks.gp'

# NUMBER counts the curves, one for a stem: their letter in text mode, the stagger of their markers otherwise.
array NUMBER[64]
solid = ''; dashed = ''; marked = ''; bands = ''; measured = ''; entries = ''; stems = ' '; numbers = 0
do for [i = 1:BLOCKS] {
    w = word(style_words, i)
    if (!known(w)) { exit error sprintf("'%s' is not a style word", w) }
    NUMBER[i] = 0
    do for [j = 1:i - 1] { if (stem(word(style_words, j)) eq stem(w)) { NUMBER[i] = NUMBER[j] } }
    if (NUMBER[i] == 0) { numbers = numbers + 1; NUMBER[i] = numbers }
    if (ROWS[i] > 1 && band(w)) { bands = bands . sprintf(' %d', i) }
    if (ROWS[i] > 0 && w eq 'meas') { measured = measured . sprintf(' %d', i) }
    if (band(w) || w eq 'meas') { continue }
    if (ROWS[i] > 1 && outside(w)) { dashed = dashed . sprintf(' %d', i) }
    if (ROWS[i] > 1 && !outside(w)) { solid = solid . sprintf(' %d', i) }
    if (ROWS[i] > 0) { stems = stems . stem(w) . ' ' }
}
both = ' ' # models with an adjusted curve: their plain one steps back
do for [i = 1:BLOCKS] { if (adjusted(word(style_words, i))) { both = both . base(word(style_words, i)) . ' ' } }
steps_back(w) = strstrt(both, ' ' . base(w) . ' ') > 0 && !adjusted(w)
width(w) = scaled(w) ? 0.8 : steps_back(w) ? 1 : adjusted(w) ? 2.6 : 2
shape(w) = scaled(w) ? (marker(w) % 2 ? 2 : 1) : steps_back(w) ? -1 : marker(w)
size(w) = scaled(w) ? 0.6 : shape(w) < 0 ? 0.1 : shape(w) % 2 ? 0.75 : 0.9
longest = 1; count = 0
do for [i = 1:BLOCKS] {
    w = word(style_words, i)
    LEGEND[i] = short(LEGEND[i], 60)
    if (band(w) || w eq 'meas') { continue }
    if (!outside(w) && strstrt(stems, ' ' . w . ' ')) {
        entries = entries . sprintf(' %d', i); count = count + 1; longest = most(longest, strlen(LEGEND[i]))
    }
    if (ROWS[i] > 1 && !outside(w) && shape(w) > 0) { marked = marked . sprintf(' %d', i) }
}
note_outside = 'outside the range of validity'
note_band = '95 % interval of the mean'
if (strlen(bands) && !text_mode) { count = count + 1; longest = most(longest, strlen(note_band)) }
if (strlen(measured)) { count = count + 1; longest = most(longest, 8) }
if (strlen(dashed)) { count = count + 1; longest = most(longest, strlen(note_outside)) }
load 'legend.gp'
if (words(axes) == 3 && !empty) {
    x_low = least(x_low, word(axes, 1) + 0); x_high = most(x_high, word(axes, 2) + 0)
    floor_y = word(axes, 3) + 0.0
    if (floor_y > 0 && y_low < 0.3 * floor_y) { y_low = 0.3 * floor_y }
}
low = x_low; high = x_high
call 'axis.gp' 'x' (log_x ? 'log' : 'zero') '0' (text_mode ? '6' : '8')
low = y_low; high = y_high
call 'axis.gp' 'y' (log_y ? 'log' : 'zero') '0.04' (text_mode ? '5' : '7')
if (!log_y && !text_mode) { set xzeroaxis lc rgb quiet lw 0.7 lt 1 }

if (unsure > x_low && !empty && !text_mode) { set object 1 rectangle from graph 0, graph 0 to first (least(unsure, x_high)), graph 1 behind fc rgb quiet fs transparent solid 0.15 noborder }

# The plot is put together from parts because gnuplot runs a loop over an empty list once. The parts name variables only.
interval(i) = int(most(1, ceil(ROWS[i] / (scaled(word(style_words, i)) ? 14.0 : 9.0))))
offset(i) = int(interval(i) * (NUMBER[i] % 4) / 4.0)
hue(i) = colour(word(style_words, i))
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
        ', for [i in measured] data index int(i) - 1 using 1:2 with points pt 15 title "measured"' }
} else {
    if (strlen(bands)) { command = command . \
        ', for [i in bands] data index int(i) - 1 using 1:2:3 with filledcurves fc rgb hue(int(i)) fs transparent solid 0.2 noborder notitle' }
    if (strlen(dashed)) { command = command . \
        ', for [i in dashed] data index int(i) - 1 using 1:2 with lines dt (7,4) lw 1.3 lc rgb hue(int(i)) notitle' }
    if (strlen(solid)) { command = command . \
        ', for [i in solid] data index int(i) - 1 using 1:2 with lines lw width(word(style_words, int(i))) lc rgb hue(int(i)) notitle' }
    if (strlen(marked)) { command = command . \
        ', for [i in marked] data index int(i) - 1 every interval(int(i))::1 + offset(int(i)) using 1:2 with points ' . \
        'pt shape(word(style_words, int(i))) ps size(word(style_words, int(i))) lw 1.3 lc rgb hue(int(i)) notitle' }
    if (strlen(in_points)) { command = command . \
        ', for [i in in_points] data index int(i) - 1 using 1:2 with points pt 7 ps 0.5 lc rgb hue(int(i)) notitle' }
    if (strlen(entries)) { command = command . \
        ', for [i in entries] keyentry with linespoints lw width(word(style_words, int(i))) lc rgb hue(int(i)) ' . \
        'pt shape(word(style_words, int(i))) ps size(word(style_words, int(i))) title LEGEND[int(i)]' }
    if (strlen(dashed)) { command = command . \
        ', keyentry with lines dt (7,4) lw 1.3 lc rgb quiet title note_outside' }
    if (strlen(bands)) { command = command . \
        ', keyentry with boxes fc rgb quiet fs transparent solid 0.3 noborder title note_band' }
    if (strlen(measured)) { command = command . \
        ', for [i in measured] data index int(i) - 1 using 1:2 with lines lw 0.9 lc rgb ink notitle' . \
        ', for [i in measured] data index int(i) - 1 using 1:2:3:4 with yerrorbars pt 2 ps 0.9 lw 1.4 lc rgb ink title "measured"' }
}
eval command
set output
