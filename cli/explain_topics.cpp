#include "cli/explain_topics.h"

#include <array>

namespace lray::cli {

namespace {

// clang-format off
constexpr std::array kTopics{
Topic{"color", "what numbers, hex digits and names of colours mean",
"A colour is written #rgb, #rrggbb or #rrggbbaa, by one of the names of CSS (crimson, steelblue), or\n"
"made by a function.\n\n"
"Hex digits and names are sRGB, as a colour picker shows them, and are made linear on reading. So are\n"
"srgb(), hsv() and hsl(). Numbers are linear: [0.5, 0.5, 0.5], rgb(0.5, 0.5, 0.5), gray(0.5) and plain\n"
"0.5 are all the same grey, of half the light of white, which a colour picker shows as #bcbcbc.\n\n"
"Where a colour is expected, a number is a grey and three numbers are red, green and blue. A colour is\n"
"no point: `center: red` is an error. Components run from 0 to 1, not to 255.\n"},
Topic{"paths", "where files named in a scene are looked for",
"A path is relative to the file in which it is written. What is not there is looked for in each `-I`\n"
"directory in order, then in those of the environment variable LRAY_PATH, which are separated by\n"
"colons. A name that begins with `std:` is in the bundled library, and nowhere else.\n\n"
"Only `/` separates names. `\\` is read as `/`, with a warning; a file that is found only by ignoring the\n"
"case of letters is read, with a warning.\n\n"
"A scene may read files below the directory of the main scene, of `-I`, `--allow` and LRAY_PATH, and\n"
"those of the library. Nothing leads out of there, neither `..` nor a symbolic link.\n"},
Topic{"precedence", "which operator binds more tightly",
"From the tightest to the loosest:\n\n"
"  f(x)  a[i]  a.b       calls, elements, fields\n"
"  ^                     power, from right to left; -2^2 is -4\n"
"  -x  +x                signs\n"
"  *  /  %               from left to right; % takes the sign of the divisor\n"
"  +  -                  from left to right\n"
"  == != < <= > >=       one at a time: write 0 < x and x < 1\n"
"  not\n"
"  and                   the right side only if the left is true\n"
"  or                    the right side only if the left is false\n"
"  if then else\n"},
Topic{"random", "random numbers that come out the same every time",
"rand(seed, i) is a number from 0 to 1 that depends on its arguments alone: the same arguments give the\n"
"same number, in any order, on every machine. There is no hidden state, and no `seed` to set once.\n\n"
"Give each use a number of its own: rand(7, i, 1) for one property of the i-th thing, rand(7, i, 2) for\n"
"the next. Change the 7 for another picture of the same kind. In a loop, an argument must be the loop's\n"
"variable, or all rounds get the same number.\n"},
Topic{"transform", "in which order steps are done",
"translate, scale, rotate_x, rotate_y, rotate_z, rotate, matrix, transform and look_at are steps, done to\n"
"the thing from top to bottom, in the order written. Then come the steps of the group around it, and so\n"
"on outwards. In terms of matrices, steps S1, S2, S3 make S3 S2 S1.\n\n"
"  box { rotate_y: 45, translate: [3, 0, 0] }   turns on the spot, then moves\n"
"  box { translate: [3, 0, 0], rotate_y: 45 }   moves, then swings about the world's axis\n\n"
"scale comes first as a rule: behind a translate it multiplies the way moved as well (W1301). Where\n"
"steps stand among other properties and children makes no difference.\n"},
Topic{"units", "degrees, metres and their like",
"Angles are in degrees everywhere, in sin() and cos() too, and counter-clockwise is positive. Lengths are\n"
"in metres. A unit directly behind a number converts it:\n\n"
"  deg rad turn     to degrees: 1turn is 360, 3.14159rad is 180\n"
"  m cm mm km       to metres: 18cm is 0.18\n\n"
"Units are multipliers and nothing else: there are no types for them. Y is up, X points to the right and\n"
"Z towards the viewer.\n"},
};
// clang-format on

}  // namespace

std::span<const Topic> topics() {
    return kTopics;
}

}  // namespace lray::cli
