# Range and tics of one axis.
#   low = ...; high = ...; call 'axis.gp' AXIS KIND PAD TICS [bare]
# AXIS x or y; KIND log, zero (linear, from 0 when nothing is negative) or tight (linear); low, high what the data need;
# PAD how much room to leave beyond them, as a fraction of the range; TICS how many at most; bare: without their numbers.
axis = ARG1; kind = ARG2; pad = ARG3 + 0.0; most_tics = ARG4 + 0.0; bare = ARGC > 4 && ARG5 eq 'bare'

if (low > high) {
    eval sprintf("set %srange [0:1]", axis)
    eval sprintf("unset %stics", axis)
} else { if (kind eq 'log') {
    low = log10(low); high = log10(high)
    if (high - low < 0.5) { middle = (low + high) / 2; low = middle - 0.25; high = middle + 0.25 }
    # A little more than nothing, or rounding would put the outermost points outside.
    room = pad * (high - low) + 1e-9; low = most(low - room, -300); high = least(high + room, 300)
    eval sprintf("set logscale %s; set %srange [%.17g:%.17g] noextend", axis, axis, 10**low, 10**high)
    first = int(ceil(low)); last = int(floor(high))
    eval sprintf("set %stics ()", axis)
    if (last > first) {
        every = int(ceil((last - first + 1.0) / most_tics))
        do for [k = first:last] {
            if (k % every == 0) { eval sprintf("set %stics add ('%s' %.17g)", axis, bare ? '' : power(k), 10.0**k) }
        }
    } else { do for [k = first - 1:last] { do for [m in (high - low < 0.8 ? '1 1.5 2 3 4 5 7' : '1 2 5')] {
        at = m * 10.0**k
        if (log10(at) >= low && log10(at) <= high) {
            text = bare ? '' : abs(k) < 4 || text_mode ? sprintf('%g', at) : sprintf('%s×%s', m, power(k))
            eval sprintf("set %stics add ('%s' %.17g)", axis, text, at)
        }
    } } }
} else {
    from_zero = kind eq 'zero' && low >= 0
    if (from_zero) { low = 0.0 }
    if (high <= low) { high = low + (low == 0 ? 1 : abs(low)) }
    room = pad * (high - low); high = high + room
    if (!from_zero) { low = low - room }
    step = (high - low) / most_tics
    magnitude = 10.0**floor(log10(step))
    digit = step / magnitude
    step = magnitude * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10)
    eval sprintf("set %srange [%.17g:%.17g] noextend; set %stics %.17g; set format %s '%s'", \
        axis, low, high, axis, step, axis, bare ? '' : '%g')
} }
