# Amplitude against wavelength, one panel a surface on common axes, with the power law fitted to it.
#   call 'spectra.gp' DATA OUTPUT TITLE STYLES
# STYLES: one word a block of DATA: s1..s8 the points of a spectrum, which begin a panel headed by their legend text; fit
# the law over the fitted band, whose legend text stands in the panel; fitx the law outside the band. Rows are m,m; some 400
# points a block are enough. bin, binx, line: bins in the fit, out of it, and lines: m,m, one standard error below and above,
# decades over the law, which stand in a strip below the panel; knee: where the spectrum bends.
data = ARG1; output = ARG2; title_text = ARG3; style_words = ARG4
x_label = 'wavelength (m)'; y_label = 'amplitude (m)'
load 'style.gp'
log_x = 1; log_y = 1
load 'blocks.gp'

# FIRST[p] is the block of points of panel p; its fits follow until FIRST[p + 1].
array FIRST[65]
panels = 0
do for [i = 1:BLOCKS] {
    w = word(style_words, i)
    if (known(w)) { panels = panels + 1; FIRST[panels] = i } else {
        if ((w ne 'fit' && w ne 'fitx' && w ne 'knee' && !(w eq 'bin' || w eq 'binx' || w eq 'line')) || panels == 0) { exit error sprintf("'%s' is not a style word here", w) }
    }
}
FIRST[panels + 1] = BLOCKS + 1
is_bins(w) = w eq 'bin' || w eq 'binx' || w eq 'line'
strips = 0
do for [i = 1:BLOCKS] { if (is_bins(word(style_words, i)) && !text_mode) { strips = 1 } }

columns = panels > 1 ? 2 : 1
rows = (panels + columns - 1) / columns
top = strlen(title_text) ? 34 : 6
panel = (panels > 1 ? 200 : 340) + 60 * strips
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
    set label 2 y_label at screen 0.03, screen (66 + 0.5 * rows * (panel + gap)) / height center rotate textcolor rgb ink
}
wide = 0.86 / columns
do for [p = 1:panels] {
    column = (p - 1) % columns
    row = (p - 1) / columns
    left = 0.13 + column * wide
    upper = text_mode ? 0.97 - 0.88 * row / rows - 0.05 : 1 - (top + row * (panel + gap) + gap + 0.0) / height
    lower = text_mode ? 0.97 - 0.88 * (row + 1) / rows + 0.03 : 1 - (top + (row + 1) * (panel + gap) + 0.0) / height
    bottom = lower
    lower = lower + strips * 62.0 / height
    eval sprintf("set tmargin at screen %.5f; set bmargin at screen %.5f", upper, lower)
    eval sprintf("set lmargin at screen %.5f; set rmargin at screen %.5f", left, left + wide - 0.03)
    # Only the outer panels carry numbers.
    x_bare = p + columns <= panels
    low = x_low; high = x_high
    call 'axis.gp' 'x' 'log' '0.03' (columns > 1 ? '5' : '8') (x_bare || strips ? 'bare' : '')
    low = y_low; high = y_high
    call 'axis.gp' 'y' 'log' '0.04' (text_mode ? '4' : '6') (column ? 'bare' : '')
    set xlabel (x_bare || strips ? '' : axis_label(x_label))
    b = FIRST[p]
    set label 3 (columns > 1 ? both_ends(LEGEND[b], 36) : short(LEGEND[b], 80)) at graph 0, graph 1 offset 0, (text_mode ? 1 : 0.7) left noenhanced textcolor rgb ink
    unset label 4
    # A point is a square as long as it is wide: strokes of one path take a fifth of the bytes of as many markers.
    dot = 10**(1.2 / (680.0 * wide) * log10(x_high / x_low))
    faint = '#20' . colour(word(style_words, b))[2:*]
    command = 'plot NaN notitle'
    if (ROWS[b] > 0) { command = command . (text_mode ? \
        ', data index b - 1 using 1:2 with dots notitle' : \
        ', data index b - 1 using ($1/dot):2:($1*dot - $1/dot):(0) with vectors nohead lw 2.4 lc rgb faint notitle') }
    do for [i = b + 1:FIRST[p + 1] - 1] {
        w = word(style_words, i)
        if (is_bins(w)) {
            if (ROWS[i] > 0) { command = command . (text_mode ? (w eq 'bin' ? sprintf(', data index %d using 1:2 with points pt "+" notitle', i - 1) : '') : \
                sprintf(', data index %d using 1:2:3:4 with yerrorbars pt %d ps 0.35 lw 1.2 lc rgb %s notitle', i - 1, w eq 'line' ? 6 : 7, \
                w eq 'binx' ? 'quiet' : 'ink')) }
            continue
        }
        if (w eq 'knee') {
            if (ROWS[i] > 0 && !text_mode) { command = command . \
                sprintf(', data index %d using 1:($2*10**-0.35):(0):($2*(10**0.35-10**-0.35)) with vectors nohead lw 1.2 dt (3,3) lc rgb quiet notitle', i - 1) }
            continue
        }
        inside = w eq 'fit'
        if (inside) { set label 4 short(LEGEND[i], 36) at graph 0.97, graph 0.07 right noenhanced textcolor rgb ink }
        if (ROWS[i] > 1) { command = command . sprintf(', data index %d using 1:2 with lines %s lc rgb ink notitle', i - 1, \
            inside ? 'lt 1 lw 1.6' : 'lt 1 lw 1.1 dt (7,4)') }
    }
    eval command
    if (strips) {
        unset label 3
        unset label 4
        eval sprintf("set tmargin at screen %.5f; set bmargin at screen %.5f", lower - 8.0 / height, bottom)
        low = x_low; high = x_high
        call 'axis.gp' 'x' 'log' '0.03' (columns > 1 ? '5' : '8') (x_bare ? 'bare' : '')
        set xlabel (x_bare ? '' : axis_label(x_label))
        unset logscale y
        set yrange [-0.3:0.3] noextend
        set ytics ('' -0.2, '' 0, '' 0.2)
        if (column == 0) { set ytics ('−0.2' -0.2, '0' 0, '0.2' 0.2) }
        command = 'plot 0 lt 1 lw 1.1 lc rgb ink notitle'
        law = 0
        do for [i = b + 1:FIRST[p + 1] - 1] {
            w = word(style_words, i)
            if (w eq 'fit' && ROWS[i] > 0) { law = 1 }
            # A bin far off the law is left out of the strip, not drawn at its edge; without a law there are none.
            if (law && is_bins(w) && ROWS[i] > 0) { command = command . \
                sprintf(', data index %d using 1:5:(log10($4/$2)) with yerrorbars pt %d ps 0.3 lw 1 lc rgb %s notitle', i - 1, \
                w eq 'line' ? 6 : 7, w eq 'binx' ? 'quiet' : 'ink') }
        }
        eval command
    }
    unset label 1
    unset label 2
}
unset multiplot
set output
