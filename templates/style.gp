# The look all charts share. Every template loads it first and then opens its canvas with eval canvas(width, height).
#
# Text charts: with dumb_size defined before (dumb_size = '100,30': columns, rows) the same templates draw with letters.
reset
set encoding utf8
set minussign
set datafile separator ','
text_mode = exists('dumb_size')

# The ink is this one colour everywhere, so that a page can replace it; the grid is translucent, fit for any background.
ink = '#222222'
quiet = '#808080'
font = 'Helvetica, Arial, sans-serif'

# Surfaces: Okabe and Ito's hues with their lightness moved until each stands out from white, and any two still differ for
# deuteranopes and protanopes. page.html has lighter ones of the dark among these colours for a dark page.
colour_s1 = '#1257D0'; colour_s2 = '#CC5500'; colour_s3 = '#1FB380'; colour_s4 = '#A8366A'
colour_s5 = '#EE9400'; colour_s6 = '#4FA6F0'; colour_s7 = '#85858F'; colour_s8 = '#734CA4'
# Their markers, where a curve is a single point.
marker_of_s(n) = int(word('7 5 9 13 11 6 4 8', n))
# Models: models.gp beside the data gives each its colour and marker, light and open for elastic contact, dark and filled
# for plastic. Dashes are not free for this: they mean outside the range of validity.
# Sweeps: one ramp from dark violet to light gold, so that the order of the values is that of the lightness.
colour_r1 = '#431575'; colour_r2 = '#2B338F'; colour_r3 = '#025185'; colour_r4 = '#04657A'; colour_r5 = '#017775'
colour_r6 = '#058A64'; colour_r7 = '#4F9737'; colour_r8 = '#939803'; colour_r9 = '#C79608'
# Methods: the surfaces' colours, each with a marker.
colour_c1 = colour_s1; colour_c2 = colour_s2; colour_c3 = colour_s3; colour_c4 = colour_s4; colour_c5 = colour_s5
colour_c6 = colour_s6; colour_c7 = colour_s7; colour_c8 = colour_s8; colour_c9 = '#8A6D1B'
marker_c1 = 7; marker_c2 = 5; marker_c3 = 9; marker_c4 = 13; marker_c5 = 11
marker_c6 = 6; marker_c7 = 4; marker_c8 = 8; marker_c9 = 12

colour_meas = ink; marker_meas = 2
# Direct solutions: the leading one, the one with other heights, the one with a hardness.
colour_dirl = ink; colour_diro = quiet; colour_dirp = '#C2185B'
marker_dirl = 7; marker_diro = 6; marker_dirp = 5

colour_cf = quiet

# A style word is a name of the tables above, then perhaps `a` (adjusted) or `S` (scale-dependent over plain), then perhaps
# `x` (outside the range of validity), `b` (the interval of the mean) or `hLN` (what lies under L of the N lines that lie
# there together). `meas` is what was measured, `dirl`, `diro` and `dirp` what was solved directly, `cf` the counterface.
hidden(w) = strlen(w) > 4 && w[strlen(w) - 2:strlen(w) - 2] eq 'h'
in_bars(w) = w eq 'meas' || w eq 'dirl' || w eq 'diro' || w eq 'dirp'
outside(w) = strlen(w) > 1 && w[strlen(w):*] eq 'x'
band(w) = strlen(w) > 1 && w[strlen(w):*] eq 'b'
stem(w) = hidden(w) ? w[1:strlen(w) - 3] : outside(w) || band(w) ? w[1:strlen(w) - 1] : w
adjusted(w) = strlen(stem(w)) == 3 && stem(w)[3:3] eq 'a'
scaled(w) = strlen(stem(w)) == 3 && stem(w)[3:3] eq 'S'
base(w) = adjusted(w) || scaled(w) ? stem(w)[1:2] : stem(w)
known(w) = exists('colour_' . base(w))
colour(w) = value('colour_' . base(w))
marker(w) = exists('marker_' . base(w)) ? value('marker_' . base(w)) : -1
single(w) = marker(w) > 0 ? marker(w) : w[1:1] eq 's' ? marker_of_s(int(w[2:2])) : 7

# Text from outside: never evaluated, never enhanced, cut to what fits; where there is little room in its middle, as names
# often differ at their end.
short(s, n) = strlen(s) > n ? s[1:n - 1] . '…' : s
both_ends(s, n) = strlen(s) > n ? s[1:int(n / 2) - 1] . '…' . s[strlen(s) - (n - int(n / 2)) + 1:*] : s
# Axis labels come from the program and may hold _{} and ^{}; a terminal shows them without the braces.
cut(s, i) = i == 0 ? s : s[1:i - 1] . s[i + 1:*]
unbrace(s) = strstrt(s, '{') ? unbrace(cut(s, strstrt(s, '{'))) : strstrt(s, '}') ? unbrace(cut(s, strstrt(s, '}'))) : s
axis_label(s) = text_mode ? unbrace(s) : s
power(k) = text_mode ? sprintf('1e%d', k) : k == 0 ? '1' : k == 1 ? '10' : sprintf('10^{%s%d}', k < 0 ? '−' : '', abs(k))

text_columns = text_mode ? int(dumb_size[1:strstrt(dumb_size, ',') - 1] + 0) : 0
canvas(w, h) = text_mode ? sprintf("set terminal dumb size %s noenhanced mono", dumb_size) : \
    sprintf("set terminal svg size %d,%d dynamic enhanced font '%s,15' background rgb '#ffffff'", w, h, font)

set border 3 lc rgb ink lw 1
set tics nomirror out scale 0.5 textcolor rgb ink
set xlabel textcolor rgb ink offset 0, 0.3
set ylabel textcolor rgb ink
set title textcolor rgb ink offset 0, -0.5
set key textcolor rgb ink noenhanced Left reverse samplen 2.2 spacing 1.1
set grid lc rgb '#B0808080' lw 0.7 lt 1
if (text_mode) {
    unset grid
    set border 15
    set tics scale 1
    set xlabel offset 0, 0
    set title offset 0, 0
}
