# What accuracy costs: relative error against time, one line a method, the chosen setting ringed.
#   call 'cost.gp' DATA OUTPUT TITLE STYLES
# STYLES: one word a block of DATA: c1..c9 methods, two letters a model (models.gp), dirl the direct solution, choice the
# chosen settings. An error below 1e-16 is none that double precision can show: its point stands on the lower edge, off the
# scale.
data = ARG1; output = ARG2; title_text = ARG3; style_words = ARG4
x_label = 'time (s)'; y_label = 'relative error'
load 'style.gp'
log_x = 1; log_y = 1
load 'blocks.gp'

# Points off the scale, which the rest of the chart does not have to make room for.
array OFF[MOST_BLOCKS]
off = 0
do for [i = 1:BLOCKS] { OFF[i] = 0 }
note_off(b, x, y) = x > 0 && y < 1e-16 ? \
    (off = off + 1, OFF[b] = OFF[b] + 1, x_low = least(x_low, x), x_high = most(x_high, x), 0) : 0
stats data using (valid(1) && valid(2) ? note_off(int(column(-2)) + 1, column(1), column(2)) : 0) nooutput

curves = ''; chosen = ''
longest = 1
do for [i = 1:BLOCKS] {
    w = word(style_words, i)
    if (!known(w) && w ne 'choice') { exit error sprintf("'%s' is not a style word here", w) }
    LEGEND[i] = short(LEGEND[i], 60)
    if (ROWS[i] + OFF[i] > 0) {
        if (w eq 'choice') { chosen = chosen . sprintf(' %d', i) } else { curves = curves . sprintf(' %d', i) }
        longest = most(longest, strlen(LEGEND[i]))
    }
}
count = words(curves) + words(chosen)
note_exact = 'on the lower edge: below 10⁻¹⁶'
if (off && !text_mode) { count = count + 1; longest = most(longest, strlen(note_exact)) }
hue(i) = colour(word(style_words, i))
load 'legend.gp'
low = x_low; high = x_high
call 'axis.gp' 'x' 'log' '0.04' (text_mode ? '6' : '8')
low = y_low; high = y_high
call 'axis.gp' 'y' 'log' '0.05' (text_mode ? '5' : '8')
lowest = empty ? 1 : 10**low
shown(y) = y < 1e-16 ? lowest : y

# See curves.gp for why the plot is put together from parts.
command = 'plot NaN notitle'
if (strlen(curves)) { command = command . (text_mode ? \
    ', for [i in curves] data index int(i) - 1 using 1:2 with points pt int(i) title LEGEND[int(i)]' : \
    ', for [i in curves] data index int(i) - 1 using 1:(shown($2)) with linespoints lw 1.4 lc rgb hue(int(i)) ' . \
    'pt marker(word(style_words, int(i))) ps 0.75 title LEGEND[int(i)]') }
if (strlen(chosen)) { command = command . (text_mode ? \
    ', for [i in chosen] data index int(i) - 1 using 1:2 with points pt 15 title LEGEND[int(i)]' : \
    ', for [i in chosen] data index int(i) - 1 using 1:(shown($2)) with points pt 6 ps 2.4 lc rgb ink notitle' . \
    ', for [i in chosen] keyentry with points pt 6 ps 1.3 lc rgb ink title LEGEND[int(i)]') }
if (off && !text_mode) { command = command . ', keyentry with points pt 7 ps 0.75 lc rgb quiet title note_exact' }
eval command
set output
