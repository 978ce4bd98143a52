# The profiles, one panel a surface; each panel has the height range of its own profile. They share one length axis unless
# one is over five times as long as another: then each has its own.
#   call 'profiles.gp' DATA OUTPUT TITLE STYLES
# STYLES: one word a block of DATA, s1..s8. The legend text of a block heads its panel. Rows are
# mm,µm; some 1000 a block are enough.
data = ARG1; output = ARG2; title_text = ARG3; style_words = ARG4
x_label = 'position (mm)'; y_label = 'height (µm)'
load 'style.gp'
log_x = 0; log_y = 0
load 'blocks.gp'
do for [i = 1:BLOCKS] { if (!known(word(style_words, i))) { exit error sprintf("'%s' is not a style word", word(style_words, i)) } }

shared = 1
do for [i = 1:BLOCKS] { shared = shared && (ROWS[i] == 0 || 5 * (X_HIGH[i] - X_LOW[i]) >= x_high - x_low) }
panel = BLOCKS > 1 ? 92 : 240
gap = shared ? 34 : 66
top = strlen(title_text) ? 34 : 6
height = top + BLOCKS * (panel + gap) + 66
eval canvas(680, height)
set output output
set multiplot
unset key
set lmargin at screen (text_mode ? 0.12 : 0.14)
set rmargin at screen (text_mode ? 0.97 : 0.965)
if (text_mode) {
    set label 2 axis_label(y_label) . '  ' . short(title_text, text_columns - 20) at screen 0.02, screen 0.99 left noenhanced
} else {
    set label 1 short(title_text, 80) at screen 0.545, screen 1 - 16.0 / height center noenhanced textcolor rgb ink
    set label 2 y_label at screen 0.022, screen (66 + 0.5 * BLOCKS * (panel + gap)) / height center rotate textcolor rgb ink
}
do for [i = 1:BLOCKS] {
    # Text has whole rows, so its panels share the height without pixels for the texts between them.
    upper = text_mode ? 0.97 - 0.9 * (i - 1) / BLOCKS - 0.05 : 1 - (top + (i - 1) * (panel + gap) + gap + 0.0) / height
    lower = text_mode ? 0.97 - 0.9 * i / BLOCKS + 0.03 : 1 - (top + i * (panel + gap) + 0.0) / height
    eval sprintf("set tmargin at screen %.5f; set bmargin at screen %.5f", upper, lower)
    low = shared ? x_low : X_LOW[i]; high = shared ? x_high : X_HIGH[i]
    call 'axis.gp' 'x' 'tight' '0' (text_mode ? '5' : '8')
    low = Y_LOW[i]; high = Y_HIGH[i]
    call 'axis.gp' 'y' 'tight' '0.06' (BLOCKS > 1 ? '5' : '7')
    if (shared && i < BLOCKS) { set format x '' }
    set xlabel (i < BLOCKS ? '' : axis_label(x_label))
    set label 3 short(LEGEND[i], 80) at graph 0, graph 1 offset 0, (text_mode ? 1 : 0.7) left noenhanced textcolor rgb ink
    if (ROWS[i] > 1) {
        plot data index i - 1 using 1:2 with lines lw 1.1 lt i lc rgb colour(word(style_words, i)) notitle
    } else { if (ROWS[i] == 1) {
        plot data index i - 1 using 1:2 with points pt 7 ps 0.5 lc rgb colour(word(style_words, i)) notitle
    } else {
        plot NaN notitle
    } }
    unset label 1
    unset label 2
}
unset multiplot
set output
