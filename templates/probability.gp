# Heights against their normal scores, one panel a surface, each with its own height scale, on a common score axis, with
# the line through the points that touch.
#   call 'probability.gp' DATA OUTPUT TITLE STYLES
# STYLES: one word a block of DATA: s1..s8 the heights of a surface, which begin a panel headed by their legend text; fit
# the line over the points it was fitted to, whose legend text stands in the panel; fitx the line beyond them. Rows are
# score,µm; some 300 points a block are enough.
data = ARG1; output = ARG2; title_text = ARG3; style_words = ARG4
x_label = 'normal score (standard deviations)'; y_label = 'height (µm)'
load 'style.gp'
log_x = 0; log_y = 0
load 'blocks.gp'

# FIRST[p] is the block of heights of panel p; its lines follow until FIRST[p + 1].
array FIRST[65]
panels = 0
do for [i = 1:BLOCKS] {
    w = word(style_words, i)
    if (known(w)) { panels = panels + 1; FIRST[panels] = i } else {
        if ((w ne 'fit' && w ne 'fitx') || panels == 0) { exit error sprintf("'%s' is not a style word here", w) }
    }
}
FIRST[panels + 1] = BLOCKS + 1

columns = panels > 1 ? 2 : 1
rows = (panels + columns - 1) / columns
top = strlen(title_text) ? 34 : 6
panel = panels > 1 ? 200 : 340
gap = 34
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
wide = 0.86 / columns
do for [p = 1:panels] {
    column = (p - 1) % columns
    row = (p - 1) / columns
    left = 0.11 + column * (wide + 0.02)
    upper = text_mode ? 0.97 - 0.88 * row / rows - 0.05 : 1 - (top + row * (panel + gap) + gap + 0.0) / height
    lower = text_mode ? 0.97 - 0.88 * (row + 1) / rows + 0.03 : 1 - (top + (row + 1) * (panel + gap) + 0.0) / height
    eval sprintf("set tmargin at screen %.5f; set bmargin at screen %.5f", upper, lower)
    eval sprintf("set lmargin at screen %.5f; set rmargin at screen %.5f", left, left + wide - 0.05)
    x_bare = p + columns <= panels
    low = x_low; high = x_high
    call 'axis.gp' 'x' 'tight' '0.03' (columns > 1 ? '6' : '9') (x_bare ? 'bare' : '')
    b = FIRST[p]
    low = Y_LOW[b]; high = Y_HIGH[b]
    do for [i = b + 1:FIRST[p + 1] - 1] { low = least(low, Y_LOW[i]); high = most(high, Y_HIGH[i]) }
    call 'axis.gp' 'y' 'tight' '0.06' (text_mode ? '4' : '5')
    set xlabel (x_bare ? '' : axis_label(x_label))
    set label 3 (columns > 1 ? both_ends(LEGEND[b], 36) : short(LEGEND[b], 80)) at graph 0, graph 1 offset 0, (text_mode ? 1 : 0.7) left noenhanced textcolor rgb ink
    unset label 4
    command = 'plot NaN notitle'
    if (ROWS[b] > 0) { command = command . (text_mode ? \
        ', data index b - 1 using 1:2 with dots notitle' : \
        ', data index b - 1 using 1:2 with lines lw 2.4 lc rgb colour(word(style_words, b)) notitle') }
    do for [i = b + 1:FIRST[p + 1] - 1] {
        inside = word(style_words, i) eq 'fit'
        if (inside) { set label 4 short(LEGEND[i], 36) at graph 0.97, graph 0.07 right noenhanced textcolor rgb ink }
        if (ROWS[i] > 1) { command = command . sprintf(', data index %d using 1:2 with lines %s lc rgb ink notitle', i - 1, \
            inside ? 'lt 1 lw 1.6' : 'lt 1 lw 1.1 dt (7,4)') }
    }
    eval command
    unset label 1
    unset label 2
}
unset multiplot
set output
