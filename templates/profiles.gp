# The profiles, a row of panels a surface: on the left each with the height range of its own profile, on the right (where there
# are several) all with the same one. A column shares one length axis; the left one does not where one profile is over five
# times as long as another.
#   call 'profiles.gp' DATA OUTPUT TITLE STYLES
# STYLES: one word a block of DATA, s1..s8 and cf, the counterface. The legend text of a block heads its panels; a block
# without rows has none. Rows are mm,µm; some 1000 a block are enough.
data = ARG1; output = ARG2; title_text = ARG3; style_words = ARG4
x_label = 'position (mm)'; y_label = 'height (µm)'
load 'style.gp'
log_x = 0; log_y = 0
load 'blocks.gp'
do for [i = 1:BLOCKS] { if (!known(word(style_words, i))) { exit error sprintf("'%s' is not a style word", word(style_words, i)) } }

shared = 1
drawn = ''
do for [i = 1:BLOCKS] {
    shared = shared && (ROWS[i] == 0 || 5 * (X_HIGH[i] - X_LOW[i]) >= x_high - x_low)
    if (ROWS[i] > 0) { drawn = drawn . sprintf(' %d', i) }
}
if (empty) { drawn = '1' }
rows = words(drawn)
columns = rows > 1 && !text_mode ? 2 : 1
panel = rows > 1 ? 92 : 240
gap = shared ? 34 : 66
heads = columns > 1 ? 22 : 0
top = (strlen(title_text) ? 34 : 6) + heads
height = top + rows * (panel + gap) + 66
eval canvas(680, height)
set output output
set multiplot
unset key
if (text_mode) {
    set label 2 axis_label(y_label) . '  ' . short(title_text, text_columns - 20) at screen 0.02, screen 0.99 left noenhanced
} else {
    set label 1 short(title_text, 80) at screen 0.545, screen 1 - 16.0 / height center noenhanced textcolor rgb ink
    set label 2 y_label at screen 0.022, screen (66 + 0.5 * rows * (panel + gap)) / height center rotate textcolor rgb ink
}
if (columns > 1) {
    set label 4 'each on its own height scale' at screen 0.32, screen 1 - (top - 8.0) / height center textcolor rgb ink
    set label 5 'all on one scale' at screen 0.78, screen 1 - (top - 8.0) / height center textcolor rgb ink
}
do for [row = 1:rows] { do for [column = 1:columns] {
    i = int(word(drawn, row))
    one = column == 2 # scale for all
    eval sprintf("set lmargin at screen %.5f; set rmargin at screen %.5f", one ? 0.62 : text_mode ? 0.12 : 0.14, \
        columns > 1 && !one ? 0.53 : text_mode ? 0.97 : 0.965)
    # Text has whole rows, so its panels share the height without pixels for the texts between them.
    upper = text_mode ? 0.97 - 0.9 * (row - 1) / rows - 0.05 : 1 - (top + (row - 1) * (panel + gap) + gap + 0.0) / height
    lower = text_mode ? 0.97 - 0.9 * row / rows + 0.03 : 1 - (top + row * (panel + gap) + 0.0) / height
    eval sprintf("set tmargin at screen %.5f; set bmargin at screen %.5f", upper, lower)
    low = shared || one ? x_low : X_LOW[i]; high = shared || one ? x_high : X_HIGH[i]
    call 'axis.gp' 'x' 'tight' '0' (text_mode || columns > 1 ? '5' : '8')
    low = one ? y_low : Y_LOW[i]; high = one ? y_high : Y_HIGH[i]
    call 'axis.gp' 'y' 'tight' '0.06' (rows > 1 ? '5' : '7')
    if ((shared || one) && row < rows) { set format x '' }
    set xlabel (row < rows ? '' : axis_label(x_label))
    unset label 3
    if (!one) { set label 3 short(LEGEND[i], 80) at graph 0, graph 1 offset 0, (text_mode ? 1 : 0.7) left noenhanced textcolor rgb ink }
    if (ROWS[i] > 1) {
        plot data index i - 1 using 1:2 with lines lw 1.1 lt i lc rgb colour(word(style_words, i)) notitle
    } else { if (ROWS[i] == 1) {
        plot data index i - 1 using 1:2 with points pt 7 ps 0.5 lc rgb colour(word(style_words, i)) notitle
    } else {
        plot NaN notitle
    } }
    unset label 1
    unset label 2
    unset label 4
    unset label 5
} }
unset multiplot
set output
