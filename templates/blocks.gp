# Looks once through the file named `data`: one block a curve, two blank lines between blocks; the first row of a block
# is its legend text, the others are x,y. A row counts when it can be drawn on the chart's axes.
# In: data, log_x, log_y, style_words. Out: BLOCKS; per block ROWS, LEGEND, X_LOW, X_HIGH, Y_LOW,
# Y_HIGH, Y_END (y at X_HIGH); x_low, x_high, y_low, y_high, without those of a panel below.
MOST_BLOCKS = 128
array ROWS[MOST_BLOCKS]
array LEGEND[MOST_BLOCKS]
array X_LOW[MOST_BLOCKS]
array X_HIGH[MOST_BLOCKS]
array Y_LOW[MOST_BLOCKS]
array Y_HIGH[MOST_BLOCKS]
array Y_END[MOST_BLOCKS]
lower_panel = 0 # height of a panel below the main one
do for [i = 1:MOST_BLOCKS] { ROWS[i] = 0; LEGEND[i] = ''; X_LOW[i] = 1e300; X_HIGH[i] = -1e300; Y_LOW[i] = 1e300; Y_HIGH[i] = -1e300 }
BLOCKS = 0
x_low = 1e300; x_high = -1e300; y_low = 1e300; y_high = -1e300

least(a, b) = a < b ? a : b
most(a, b) = a > b ? a : b
drawable(x, y) = abs(x) < 1e300 && abs(y) < 1e300 && (!log_x || x > 0) && (!log_y || y > 0)
note_row(b, x, y) = (ROWS[b] = ROWS[b] + 1, Y_END[b] = x >= X_HIGH[b] ? y : Y_END[b], X_LOW[b] = least(X_LOW[b], x), X_HIGH[b] = most(X_HIGH[b], x), \
    Y_LOW[b] = least(Y_LOW[b], y), Y_HIGH[b] = most(Y_HIGH[b], y), 0)
look_at(b) = valid(1) && valid(2) && drawable(column(1), column(2)) ? note_row(b, column(1), column(2)) : 0
stats data using (look_at(int(column(-2)) + 1)) nooutput

# A comma splits even a quoted field, so legends are read with a separator that does not occur.
note_legend(b) = (BLOCKS = b, LEGEND[b] = strcol(1), 0)
set datafile separator "\t"
stats data using (column(0) == 0 ? note_legend(int(column(-2)) + 1) : 0) nooutput
set datafile separator ','

do for [i = 1:BLOCKS] {
    if (scaled(word(style_words, i))) { continue }
    x_low = least(x_low, X_LOW[i]); x_high = most(x_high, X_HIGH[i])
    y_low = least(y_low, Y_LOW[i]); y_high = most(y_high, Y_HIGH[i])
}
empty = x_low > x_high
if (words(style_words) != BLOCKS) {
    exit error sprintf('%s has %d blocks, but %d style words were given', data, BLOCKS, words(style_words))
}

# Blocks that make a line, and those of a single point.
in_lines = ''
in_points = ''
do for [i = 1:BLOCKS] {
    if (band(word(style_words, i)) || hidden(word(style_words, i)) || scaled(word(style_words, i)) || word(style_words, i) eq 'meas') { continue }
    if (ROWS[i] > 1) { in_lines = in_lines . sprintf(' %d', i) }
    if (ROWS[i] == 1) { in_points = in_points . sprintf(' %d', i) }
}
if (empty) { set label 1000 'no data in range' at graph 0.5, graph 0.5 center textcolor rgb ink }
