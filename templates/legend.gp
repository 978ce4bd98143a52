# Canvas, title, axis labels and a legend below the data; for charts of one panel.
# In: title_text, x_label, y_label, output, count entries of the legend, longest of them in characters; lower_panel.
key_size = count > 4 && longest > 33 ? 13 : 15
key_columns = int(most(1, least(count, floor(670.0 / (54 + 0.49 * key_size * longest)))))
key_rows = int(ceil(1.0 * count / key_columns))
top = strlen(title_text) ? 36 : 12
below = 14 + 1.65 * key_size * key_rows
height = int(ceil(top + 340 + lower_panel + 66 + below))
eval canvas(680, height)
set output output
if (strlen(title_text)) { set title short(title_text, 80) noenhanced }
set xlabel axis_label(x_label)
if (text_mode) {
    set label 2 axis_label(y_label) at screen 0.02, screen 0.99 left
    set key bmargin center vertical
} else {
    set ylabel y_label
    set tmargin at screen 1 - 1.0 * top / height
    set bmargin at screen 1 - 1.0 * (top + 340) / height
    # gnuplot reckons a character wider than the font draws it; the negative width takes that back.
    eval sprintf("set key at screen 0.5, %.4f center top vertical maxrows %d width %.1f font ',%d'", below / height, \
        key_rows, -0.28 * longest, key_size)
}
