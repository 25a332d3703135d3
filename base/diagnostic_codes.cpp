// The table of codes: what `--explain` says of each, with an example that is wrong and one that is
// right.
#include "base/diagnostic_codes.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "base/assert.h"

namespace lray {
namespace {

#define LRAY_CODE(id) Code::id, #id

// clang-format off
constexpr CodeInfo kInfos[] = {
{LRAY_CODE(E0001), "unexpected character",
 "This character has no meaning in a scene. It may have slipped in with text copied from elsewhere.",
 "sphere { radius: 1 @ }",
 "sphere { radius: 1 }"},
{LRAY_CODE(E0002), "not UTF-8",
 "Scenes are UTF-8 text. These bytes are not; the file may be in an older encoding such as Latin-1, "
 "or in UTF-16. Save it as UTF-8.",
 "info { title: \"caf\xe9\" }",
 "info { title: \"caf\xc3\xa9\" }"},
{LRAY_CODE(E0003), "binary file",
 "A scene is text, and this file holds NUL bytes: it is a picture, an archive or something else "
 "binary. Pictures and meshes are named by properties, not included.",
 "include \"floor.png\"",
 "include \"floor.lrs\""},
{LRAY_CODE(E0004), "name with a character outside ASCII",
 "Names consist of the letters a to z and A to Z, digits and `_`. Some letters of other alphabets "
 "look the same as Latin ones, so that two names could look alike and differ. Strings may hold any "
 "text.",
 "let b\xc3\xa4ll = sphere { }",
 "let ball = sphere { }"},
{LRAY_CODE(E0005), "unclosed string",
 "A string ends with `\"` on the line where it begins. A line break inside is written `\\n`.",
 "info { title: \"Four balls }",
 "info { title: \"Four balls\" }"},
{LRAY_CODE(E0006), "`#` is no comment",
 "Comments start with `//`, or stand between `/*` and `*/`. A `#` begins a colour, like `#ff8000`.",
 "# my scene\nsphere { }",
 "// my scene\nsphere { }"},
{LRAY_CODE(E0007), "unknown unit",
 "A number may carry a unit: deg, rad or turn for angles, m, cm, mm or km for lengths. It stands "
 "directly behind the number.",
 "sphere { radius: 30px }",
 "sphere { radius: 30cm }"},
{LRAY_CODE(E0008), "malformed number",
 "Numbers look like 12, 0.5, 1e-3, 1_000 or 0xff. There is one decimal point, and it is a point.",
 "sphere { radius: 1.2.3 }",
 "sphere { radius: 1.23 }"},
{LRAY_CODE(E0009), "unknown escape in a string",
 "After a backslash in a string comes one of n, t, \", \\ or u{...} with a hexadecimal code point. "
 "In paths write `/`.",
 "info { title: \"100\\% glass\" }",
 "info { title: \"100% glass\" }"},
{LRAY_CODE(E0010), "malformed colour",
 "A colour is `#` and 3, 6 or 8 hexadecimal digits: #rgb, #rrggbb or #rrggbbaa.",
 "let c = #12345",
 "let c = #123456"},
{LRAY_CODE(E0011), "unclosed comment",
 "A comment that begins with `/*` ends with `*/`. Comments nest: each `/*` needs a `*/` of its own.",
 "/* the floor\nrectangle { }",
 "/* the floor */\nrectangle { }"},

{LRAY_CODE(E0101), "unclosed bracket",
 "A `(` or `[` needs its `)` or `]`. The message points at the opening bracket; the closing one is "
 "missing somewhere after it, or is of the other kind.",
 "sphere { center: [0, 1, 0 }",
 "sphere { center: [0, 1, 0] }"},
{LRAY_CODE(E0102), "name expected",
 "After `let`, `fn`, `for` and the like comes a name, made of letters, digits and `_`, and not "
 "beginning with a digit.",
 "let 2nd = sphere { }",
 "let second = sphere { }"},
{LRAY_CODE(E0103), "unclosed brace",
 "A `{` needs its `}`. Where the indentation tells which block was left open, the message points "
 "there.",
 "group {\n  sphere { radius: 1\n}",
 "group {\n  sphere { radius: 1 }\n}"},
{LRAY_CODE(E0104), "closing bracket that closes nothing",
 "There is no open bracket of this kind here. Perhaps there is one too many, or the opening one was "
 "deleted.",
 "sphere { } }",
 "sphere { }"},
{LRAY_CODE(E0105), "separator missing",
 "Items in braces are separated by a new line, `,` or `;`. After an item that ends in `}` it may be "
 "left out.",
 "sphere { radius: 1 center: [0, 0, 0] }",
 "sphere { radius: 1, center: [0, 0, 0] }"},
{LRAY_CODE(E0106), "`,` or closing bracket expected",
 "Arguments in `( )` and elements in `[ ]` are separated by commas.",
 "sphere { center: [0 1 0] }",
 "sphere { center: [0, 1, 0] }"},
{LRAY_CODE(E0107), "name that does nothing",
 "A name at the begin of an item is followed by `:` and a value, to set a property, by `{`, to make "
 "a thing, or by `=` and a value, to change a `var`. To give something a name, write `let name = "
 "...`; a function is `fn name(x) = ...`, a loop `for x in xs { ... }`.",
 "sphere { radius 1 }",
 "sphere { radius: 1 }"},
{LRAY_CODE(E0108), "item cannot start so",
 "An item starts with a name or a keyword: a property `name: value`, a thing `name { }`, a "
 "definition `let name = ...` or a statement. Numbers, strings and brackets are values and stand "
 "behind one of these.",
 "sphere { [0, 1, 0] }",
 "sphere { center: [0, 1, 0] }"},
{LRAY_CODE(E0109), "value expected",
 "Here a value is missing: a number, a string, a colour, a list like [0, 1, 0], a name or a block.",
 "sphere { radius: }",
 "sphere { radius: 1 }"},
{LRAY_CODE(E0110), "chained comparison",
 "A comparison has two sides. Join two of them with `and`.",
 "let x = 0.5\nlet r = if 0 < x < 1 then 1 else 2",
 "let x = 0.5\nlet r = if 0 < x and x < 1 then 1 else 2"},
{LRAY_CODE(E0111), "`=` in a condition",
 "`=` gives a name to a value. To compare, use `==`.",
 "let a = 1\nlet r = if a = 1 then 1 else 2",
 "let a = 1\nlet r = if a == 1 then 1 else 2"},
{LRAY_CODE(E0112), "operator of another language",
 "The operators are + - * / % ^, == != < <= > >=, and the words `and`, `or`, `not`.",
 "let a = 1\nlet r = if a > 0 && a < 2 then 1 else 2",
 "let a = 1\nlet r = if a > 0 and a < 2 then 1 else 2"},
{LRAY_CODE(E0113), "line starts with an operator",
 "A line that is complete ends its item. To go on in the next line, end this one with the operator.",
 "let y = 2\n  * 3",
 "let y = 2 *\n  3"},
{LRAY_CODE(E0114), "keyword as a name",
 "This word belongs to the language and cannot be the name of anything else.",
 "let include = 1",
 "let included = 1"},
{LRAY_CODE(E0115), "nested too deeply",
 "Brackets, blocks and operators may be nested 256 deep. Scenes written by hand never are; for one "
 "that a program wrote, raise the limit with --max-nesting.",
 "let x = ((((1))))  // with 300 brackets",
 "let x = 1"},
{LRAY_CODE(E0116), "braces missing",
 "The body of a block, a loop or an `if` stands in braces, and `{` on the line of its head.",
 "sphere\n{ radius: 1 }",
 "sphere {\n  radius: 1\n}"},
{LRAY_CODE(E0117), "incomplete `if`",
 "A choice between two values needs `if`, `then` and `else`. As a statement, `if` has a body in "
 "braces, and `else`, which may be missing, stands right behind it.",
 "let r = if 1 < 2 then 3",
 "let r = if 1 < 2 then 3 else 4"},
{LRAY_CODE(E0118), "not allowed here",
 "Some items have their places: `param` and `import` stand at the top level of a file, `include` "
 "there or in a group, `lrs` with a version at the very begin.",
 "sphere {\n  include \"parts.lrs\"\n}",
 "group {\n  include \"parts.lrs\"\n}"},
{LRAY_CODE(E0119), "`break` or `return` outside",
 "`break` and `continue` belong in a loop, `return` in a function. A function, a component and the "
 "block of a value inside of them cannot leave them.",
 "let r = 1\nbreak",
 "let r = 1"},
{LRAY_CODE(E0120), "not available in this version",
 "This part of the language is planned but does not exist in this version of lray: the shapes union, "
 "intersection, difference and text, and a few properties.",
 "union {\n  sphere { }\n}",
 "group {\n  sphere { }\n}"},

{LRAY_CODE(E0201), "unknown name",
 "Nothing of this name is defined here. A name given with `let` exists from its line to the end of "
 "the braces it stands in.",
 "spere { radius: 1 }",
 "sphere { radius: 1 }"},
{LRAY_CODE(E0202), "used before its definition",
 "A name can be used after the line that defines it, not before.",
 "sphere { radius: r }\nlet r = 1",
 "let r = 1\nsphere { radius: r }"},
{LRAY_CODE(E0203), "already defined",
 "In the same braces a name is given once; the types of the language cannot be redefined at all.",
 "let a = 1\nlet a = 2",
 "let a = 1\nlet b = 2"},
{LRAY_CODE(E0204), "not assignable",
 "`let` gives a name to a value once and for all. A property is set with `:`.",
 "sphere { radius = 1 }",
 "sphere { radius: 1 }"},
{LRAY_CODE(E0205), "outer variable in a function",
 "What a function or component gives depends on its parameters alone, so that it can be kept and "
 "used again. A `var` around it may change: pass its value as a parameter. A `let` may be used.",
 "var n = 2\nfn twice() = 2 * n\nsphere { radius: twice() }",
 "var n = 2\nfn twice(n) = 2 * n\nsphere { radius: twice(n) }"},
{LRAY_CODE(E0206), "private name",
 "Names that begin with `_` belong to their own file; an import does not give them.",
 "import \"std:materials.lrs\" as mat\nsphere { material: mat._base }",
 "import \"std:materials.lrs\" as mat\nsphere { material: mat.chalk }"},
{LRAY_CODE(E0207), "not in the imported file",
 "The imported file does not define this name at its top level, or it is a `var`, which an import "
 "does not give.",
 "import \"std:materials.lrs\" as mat\nsphere { material: mat.chalc }",
 "import \"std:materials.lrs\" as mat\nsphere { material: mat.chalk }"},

{LRAY_CODE(E0301), "wrong type",
 "The property, operator or function needs a value of another type.",
 "sphere { radius: \"1\" }",
 "sphere { radius: 1 }"},
{LRAY_CODE(E0302), "lists of different lengths",
 "Lists are added, subtracted, multiplied and divided element by element, so both need the same "
 "number of elements.",
 "let v = [1, 2, 3] + [1, 2]",
 "let v = [1, 2, 3] + [1, 2, 0]"},
{LRAY_CODE(E0303), "wrong number of elements",
 "A point or direction has three numbers, a size in a plane has two.",
 "sphere { center: [0, 1] }",
 "sphere { center: [0, 1, 0] }"},
{LRAY_CODE(E0304), "out of range",
 "The number is outside of what makes sense here: a radius is greater than 0, a field of view is "
 "between 0 and 180 degrees.",
 "sphere { radius: -1 }",
 "sphere { radius: 1 }"},
{LRAY_CODE(E0305), "argument missing",
 "The function needs more arguments than it was given.",
 "let x = clamp(5, 0)",
 "let x = clamp(5, 0, 1)"},
{LRAY_CODE(E0306), "argument too many",
 "The function takes fewer arguments, or has no parameter of this name.",
 "let x = sqrt(2, 3)",
 "let x = sqrt(2)"},
{LRAY_CODE(E0307), "not a function",
 "Only functions are called with `( )`.",
 "let r = 2\nlet x = r(3)",
 "let r = 2\nlet x = r * 3"},
{LRAY_CODE(E0308), "whole number expected",
 "Counts and indices are whole numbers. Nothing is rounded silently: use floor() or round().",
 "render { resolution: [640.5, 480] }",
 "render { resolution: [640, 480] }"},
{LRAY_CODE(E0309), "colour where a point is needed",
 "Three numbers can be a colour, but a colour is never a point or a direction.",
 "sphere { center: red }",
 "sphere { center: [1, 0, 0] }"},
{LRAY_CODE(E0310), "transform cannot be inverted",
 "A scale of 0, or a matrix that flattens space, leaves nothing to hit. For a flat shape use "
 "rectangle, disk or triangle.",
 "box { scale: [1, 0, 1] }",
 "rectangle { size: [1, 1] }"},
{LRAY_CODE(E0311), "view without a direction",
 "A camera looks from `position` to `look_at`; these must differ, and `up` must not point along the "
 "view.",
 "camera { position: [0, 0, 5], look_at: [0, 0, 5] }",
 "camera { position: [0, 0, 5], look_at: [0, 0, 0] }"},
{LRAY_CODE(E0312), "malformed format text",
 "In the text of format() a value stands for `{}`, and a number with two decimals for `{:.2}`, up to "
 "17 of them. A brace that is meant as such is written twice.",
 "info { title: format(\"{x}\") }",
 "info { title: format(\"{{x}}\") }"},

{LRAY_CODE(E0401), "unknown property",
 "This kind of thing has no property of this name.",
 "sphere { radios: 1 }",
 "sphere { radius: 1 }"},
{LRAY_CODE(E0402), "property set twice",
 "A property is set once in its braces. Only the steps of a transform (translate, rotate_x, scale "
 "and so on) may be repeated.",
 "sphere {\n  radius: 1\n  radius: 2\n}",
 "sphere {\n  radius: 2\n}"},
{LRAY_CODE(E0403), "unknown choice",
 "The property takes one of a few words, and this is not one of them.",
 "let m = material { model: \"phongg\" }",
 "let m = material { model: \"phong\" }"},
{LRAY_CODE(E0404), "function places something",
 "A function gives a value. What is placed in the scene comes from a component, which is used like "
 "a built-in block, or from a node that the function returns.",
 "fn ball(r) {\n  sphere { radius: r }\n}",
 "component ball(r = 1) {\n  sphere { radius: r }\n}\nball { r: 2 }"},
{LRAY_CODE(E0405), "second `render` or `info`",
 "A scene has one `render` block and one `info` block, with all it includes.",
 "render { resolution: [640, 480] }\nrender { background: white }",
 "render { resolution: [640, 480], background: white }"},
{LRAY_CODE(E0406), "required property missing",
 "Without this property the thing is not defined.",
 "triangle { a: [0, 0, 0], b: [1, 0, 0] }",
 "triangle { a: [0, 0, 0], b: [1, 0, 0], c: [0, 1, 0] }"},
{LRAY_CODE(E0407), "a block called like a function",
 "Blocks take their properties by name, between braces. Parentheses call functions.",
 "sphere(radius: 2)",
 "sphere { radius: 2 }"},
{LRAY_CODE(E0408), "cannot be placed",
 "Only shapes, groups and meshes can stand in a scene. A material is given to a shape with "
 "`material: name`; numbers and lists are values of properties.",
 "let m = material { diffuse: red }\nm { }",
 "let m = material { diffuse: red }\nsphere { material: m }"},
{LRAY_CODE(E0409), "no such field",
 "The value has no field of this name. Vectors have .x .y .z .w, colours .r .g .b .a.",
 "let p = [1, 2, 3]\nlet q = p.w",
 "let p = [1, 2, 3]\nlet q = p.z"},
{LRAY_CODE(E0410), "property outside a block",
 "A property belongs to the braces of the thing it describes.",
 "radius: 1\nsphere { }",
 "sphere { radius: 1 }"},
{LRAY_CODE(E0411), "conflicting properties",
 "These properties say the same in two ways; give one of them.",
 "rectangle { size: [1, 1], corner: [0, 0, 0] }",
 "rectangle { size: [1, 1] }"},
{LRAY_CODE(E0412), "child not allowed here",
 "Things with children are groups. A shape takes only a material in its braces.",
 "sphere {\n  sphere { radius: 0.5 }\n}",
 "group {\n  sphere { }\n  sphere { radius: 0.5 }\n}"},

{LRAY_CODE(E0503), "outside of the domain",
 "The operation has no number as its result: a division by zero, the root of a negative number, or "
 "something too large for a number.",
 "let n = 0\nlet z = 1 / n",
 "let n = 2\nlet z = 1 / n"},
{LRAY_CODE(E0504), "index out of range",
 "The elements of a list are counted from 0, so the last of three is number 2.",
 "let xs = [10, 20, 30]\nlet x = xs[3]",
 "let xs = [10, 20, 30]\nlet x = xs[2]"},
{LRAY_CODE(E0505), "nothing in it",
 "A list without elements has no least one, and a group with nothing in it has no bounds.",
 "let least = min([])",
 "let least = min([3, 1, 2])"},
{LRAY_CODE(E0506), "no `return`",
 "A function with a body gives what follows `return`. Here its end was reached without one: often "
 "an `else` is missing.",
 "fn side(x) {\n  if x > 0 { return 1 }\n}\nsphere { radius: side(-1) }",
 "fn side(x) {\n  if x > 0 { return 1 }\n  return 2\n}\nsphere { radius: side(-1) }"},
{LRAY_CODE(E0507), "assertion",
 "What `assert` says must hold does not hold. Where it compares two values, both are shown.",
 "let steps = 2\nassert(steps >= 3, \"a stair needs at least 3 steps\")",
 "let steps = 3\nassert(steps >= 3, \"a stair needs at least 3 steps\")\nsphere { radius: steps }"},
{LRAY_CODE(E0508), "error of the scene",
 "The scene itself says that something is wrong, by error().",
 "let width = -2\nlet radius = if width > 0 then width / 2 else error(\"the width must be positive\")",
 "let width = 2\nlet radius = if width > 0 then width / 2 else error(\"the width must be positive\")"},
{LRAY_CODE(E0511), "too many nested calls",
 "Functions or components call each other deeper than the limit. A function that calls itself must "
 "stop at some point.",
 "fn f(n) = f(n)\nprint(f(1))",
 "fn f(n) = if n == 0 then 0 else f(n - 1)\nprint(f(100))"},
{LRAY_CODE(E0512), "too many steps",
 "Evaluating the scene takes more steps than the limit allows, so that no scene can keep a machine "
 "busy for ever; raise it with --max-steps.",
 "let a = [1, true]\nlet b = [a, a]\nlet c = [b, b]  // and so on, forty times, then: c == d",
 "let c = [1, true]\nlet same = c == [1, true]"},
{LRAY_CODE(E0513), "too many things",
 "The scene holds more primitives than the limit allows, or its instances lead to more places than "
 "can be numbered. What is placed often is stored, and counted, once. The limit keeps a small file "
 "from filling the memory; raise it with --max-primitives.",
 "// more than 50 000 000 of these:\nsphere { }",
 "mesh { file: \"cloud.obj\" }  // one mesh, used several times, is stored once"},
{LRAY_CODE(E0514), "list too long",
 "A list would have more elements than the limit, or lists and records are nested too deep.",
 "let squares = [for i in range(1000): i * i]",
 "let squares = [for i in range(10): i * i]\nsphere { radius: squares[3] }"},
{LRAY_CODE(E0515), "includes nested too deeply or too many",
 "Files may include others 64 deep, and 10 000 in all; raise the limits with --max-include-depth "
 "and --max-files.",
 "// level1.lrs, which includes level2.lrs, and so on to level65.lrs\ninclude \"level2.lrs\"",
 "include \"level2.lrs\"\ninclude \"level3.lrs\""},
{LRAY_CODE(E0516), "out of memory, or file too large",
 "The files of the scene together are larger than their limit (--max-scene-bytes, "
 "--max-mesh-bytes), or its values take more memory than theirs (--max-value-bytes), or a mesh takes longer or more "
 "memory to be imported than it may (--max-import-seconds, --max-import-bytes).",
 "mesh { file: \"whole-city.obj\" }  // 9 GiB",
 "mesh { file: \"one-street.obj\" }"},
{LRAY_CODE(E0517), "prints too much",
 "The scene prints more than the limit, perhaps in a loop that does not end.",
 "for i in range(1000) { print(\"step\", i) }",
 "for i in range(10) { print(\"step\", i) }"},

{LRAY_CODE(E0601), "file not found",
 "A path is relative to the file it is written in; after that the directories given by -I and "
 "LRAY_PATH are searched.",
 "mesh { file: \"buny.obj\" }  // the file is bunny.obj",
 "mesh { file: \"bunny.obj\" }"},
{LRAY_CODE(E0602), "file includes itself",
 "The chain of includes leads back to a file that is still being read.",
 "// a.lrs\ninclude \"a.lrs\"",
 "// a.lrs\ninclude \"b.lrs\""},
{LRAY_CODE(E0603), "newer version of the language",
 "The scene says that it needs a newer version of the language than this program knows.",
 "lrs 2.0\nsphere { }",
 "lrs 1.0\nsphere { }"},
{LRAY_CODE(E0604), "file cannot be read",
 "The file is there, but it is a directory or a device, or the system does not let it be read.",
 "include \".\"",
 "include \"parts.lrs\""},
{LRAY_CODE(E0605), "file outside of the scene's directories",
 "A scene may read files below its own directory and those named by -I, --allow and LRAY_PATH, so "
 "that a scene from a stranger cannot reach yours. If you trust it, allow the directory.",
 "mesh { file: \"/home/me/bunny.obj\" }",
 "mesh { file: \"bunny.obj\" }  // or run lray with --allow /home/me"},

{LRAY_CODE(E0701), "mesh file not understood",
 "The mesh file is not what its format says: for example a vertex without three numbers. Of a file "
 "that is no text the message tells the byte; of one that is imported by Assimp what that says, or "
 "that it crashed.",
 "v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",
 "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"},
{LRAY_CODE(E0702), "vertex that does not exist",
 "A face names a vertex, normal or texture coordinate that the mesh does not have. In OBJ files "
 "they count from 1, in PLY files and in `triangles:` from 0.",
 "mesh {\n  positions: [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n  triangles: [[1, 2, 3]]\n}",
 "mesh {\n  positions: [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n  triangles: [[0, 1, 2]]\n}"},
{LRAY_CODE(E0703), "picture not understood",
 "The file is not a PNG, JPEG, PPM, PFM, Radiance HDR or OpenEXR picture, it is damaged, or the "
 "picture is too large or too small for what it is to be.",
 "heightfield { image: \"notes.png\" }  // a text file",
 "heightfield { image: \"hills.png\", scale_y: 0.2 }"},
{LRAY_CODE(E0704), "mesh without faces",
 "There is nothing to see: the mesh, or the part of it that was asked for, has no faces.",
 "v 0 0 0\nv 1 0 0\nv 0 1 0",
 "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"},
{LRAY_CODE(E0705), "unsupported file format",
 "lray does not read this kind of file, or this feature of it. STL, glTF, OFF, FBX, Collada and 3DS "
 "are read where lray was built with Assimp.",
 "mesh { file: \"chair.blend\" }",
 "mesh { file: \"chair.obj\" }"},
{LRAY_CODE(E0706), "mistake in an NFF file",
 "What stands in the NFF file is not what its format says: for example a sphere without its four numbers, or a "
 "shape before the first `f`.",
 "b 0.1 0.1 0.3\nf 1 0.5 0.3 0.8 0.2 10 0 1\ns 0 0 0\ns 2 0 0 0.5",
 "b 0.1 0.1 0.3\nf 1 0.5 0.3 0.8 0.2 10 0 1\ns 0 0 0 1\ns 2 0 0 0.5"},

{LRAY_CODE(W1101), "unused",
 "The name is defined, and nothing uses it. Begin it with `_` if that is meant.",
 "group {\n  let r = 2\n  sphere { radius: 1 }\n}",
 "group {\n  let r = 2\n  sphere { radius: r }\n}"},
{LRAY_CODE(W1102), "hides an outer name",
 "Inside these braces the name means the new value; the outer one cannot be reached.",
 "let r = 1\ngroup {\n  let r = 2\n  sphere { radius: r }\n}",
 "let r = 1\ngroup {\n  let inner_r = 2\n  sphere { radius: inner_r }\n}"},
{LRAY_CODE(W1103), "never reached",
 "What follows `return`, `break` or `continue` in the same braces never runs.",
 "fn f(x) {\n  return x\n  print(x)\n}\nsphere { radius: f(1) }",
 "fn f(x) {\n  print(x)\n  return x\n}\nsphere { radius: f(1) }"},
{LRAY_CODE(W1104), "always the same",
 "The condition compares two values that never change, or the loop has no way to end.",
 "if 1 == 2 { sphere { radius: 1 } }",
 "let detail = 2\nif detail == 2 { sphere { radius: 1 } }"},
{LRAY_CODE(W1105), "same random number",
 "A random number is a function of its arguments: `rand(7)` is the same each time. In a loop, add "
 "what changes.",
 "for i in range(3) { sphere { center: [i, 0, 0], radius: rand(7) } }",
 "for i in range(3) { sphere { center: [i, 0, 0], radius: rand(7, i) } }"},
{LRAY_CODE(W1106), "warning of the scene",
 "The scene itself warns of something, by warn().",
 "let trees = 5000\nlet is_fast = trees < 1000 or warn(\"so many trees take minutes\")",
 "let trees = 500\nlet is_fast = trees < 1000 or warn(\"so many trees take minutes\")"},

{LRAY_CODE(W1201), "no area",
 "The corners lie on a line, so no ray can hit the shape. It is left out.",
 "triangle { a: [0, 0, 0], b: [1, 1, 1], c: [2, 2, 2] }",
 "triangle { a: [0, 0, 0], b: [1, 1, 1], c: [2, 2, 0] }"},
{LRAY_CODE(W1203), "camera inside an object",
 "The camera is inside a closed object that hides everything else: the picture has one colour. A "
 "room is not meant by this, with things in it; nor are glass, textures and what shines.",
 "camera { position: [0, 0, 5] }\nsphere { radius: 6 }",
 "camera { position: [0, 0, 15] }\nsphere { radius: 6 }"},
{LRAY_CODE(W1204), "light inside an opaque object",
 "No light leaves a closed, opaque object that casts a shadow. A bulb around its light needs "
 "`casts_shadow: false`, or glass.",
 "camera { position: [0, 0, 15] }\npoint_light { position: [0, 4, 0] }\n"
 "sphere { center: [0, 4, 0], radius: 0.2 }",
 "camera { position: [0, 0, 15] }\npoint_light { position: [0, 4, 0] }\n"
 "sphere { center: [0, 4, 0], radius: 0.2, casts_shadow: false }"},
{LRAY_CODE(W1205), "nothing in view",
 "Nothing of the scene is before the camera, so the picture will be empty. Often `look_at` was "
 "forgotten: without it the camera looks at [0, 0, 0].",
 "camera { position: [0, 1, 5], look_at: [0, 1, 9] }\nsphere { }",
 "camera { position: [0, 1, 5], look_at: [0, 0, 0] }\nsphere { }"},
{LRAY_CODE(W1206), "coincident surfaces",
 "Two surfaces of different materials are exactly in the same place, so that only chance decides "
 "which one shows. Move one of them a little.",
 "camera { position: [0, 2, 6] }\nrectangle { material { diffuse: red } }\n"
 "rectangle { material { diffuse: blue } }",
 "camera { position: [0, 2, 6] }\nrectangle { material { diffuse: red } }\n"
 "rectangle { center: [0, 0.001, 0], material { diffuse: blue } }"},

{LRAY_CODE(W1301), "scale after translate",
 "The steps of a transform are done in the order written, so this scale also multiplies the "
 "distance moved before. Usually the scale comes first.",
 "sphere { translate: [3, 0, 0], scale: 2 }",
 "sphere { scale: 2, translate: [3, 0, 0] }"},
{LRAY_CODE(W1302), "angle looks like radians",
 "Angles are degrees, and this number is a well-known fraction of pi. Write degrees, or add the "
 "unit `rad`.",
 "box { rotate_y: 3.14159 }",
 "box { rotate_y: 180 }"},
{LRAY_CODE(W1303), "mirrored by negative scale",
 "The transform turns left and right around, as a mirror does. That is often meant, so this is only "
 "told with `-W W1303`.",
 "box { scale: [-1, 1, 1] }",
 "box { rotate_y: 180 }",
 false},

{LRAY_CODE(W1401), "property the model does not use",
 "The reflection model of this material ignores the property.",
 "let m = material { model: \"phong\", roughness: 0.3 }",
 "let m = material { model: \"cook_torrance\", roughness: 0.3 }"},
{LRAY_CODE(W1402), "gives back more light than it gets",
 "diffuse, reflect and transmit together exceed 1, so that the surface makes light of its own.",
 "let m = material { diffuse: 0.8, reflect: 0.5 }",
 "let m = material { diffuse: 0.5, reflect: 0.5 }"},
{LRAY_CODE(W1403), "colour looks like 0 to 255",
 "The numbers of a colour run from 0 to 1. Colours from a colour picker are written #rrggbb.",
 "let m = material { diffuse: [255, 0, 0] }",
 "let m = material { diffuse: #ff0000 }"},
{LRAY_CODE(W1404), "`ior` below 1",
 "No ordinary matter has an index of refraction below 1: water has 1.33, glass 1.5.",
 "let m = material { transmit: 0.9, diffuse: 0, ior: 0.67 }",
 "let m = material { transmit: 0.9, diffuse: 0, ior: 1.5 }"},
{LRAY_CODE(W1405), "unused material",
 "The main file defines a material, and nothing uses it. Begin its name with `_` if that is meant. "
 "Files that are included, or that place nothing, may hold what they like.",
 "let oak = material { diffuse: #b07d48 }\nsphere { }",
 "let oak = material { diffuse: #b07d48 }\nsphere { material: oak }"},

{LRAY_CODE(W1501), "no camera",
 "The scene has no camera; one is placed so that everything is in view.",
 "sphere { }",
 "camera { position: [0, 2, 6] }\nsphere { }"},
{LRAY_CODE(W1502), "no light",
 "The scene has no light and no environment. It is painted flat, each object in the colour of its "
 "`diffuse`, instead of black. With `-n 1` and with `--shading flat` that is what is asked for.",
 "camera { position: [0, 2, 6] }\nsphere { }",
 "camera { position: [0, 2, 6] }\ndirectional_light { direction: [-1, -2, -1.5] }\nsphere { }"},
{LRAY_CODE(W1503), "empty scene",
 "The scene holds nothing to see. A thing made with `let` is not yet placed: write its name and "
 "braces.",
 "let ball = sphere { }",
 "let ball = sphere { }\nball { }"},

{LRAY_CODE(W1603), "backslash in a path",
 "The separator in paths is `/`, on every system. The backslash was read as one.",
 "mesh { file: \"meshes\\\\bunny.obj\" }",
 "mesh { file: \"meshes/bunny.obj\" }"},
{LRAY_CODE(W1604), "letter case of a file name",
 "The file was found only by ignoring upper and lower case. On another system it will not be found.",
 "mesh { file: \"Bunny.OBJ\" }  // the file is bunny.obj",
 "mesh { file: \"bunny.obj\" }"},
{LRAY_CODE(W1605), "absolute path",
 "The path starts at the root of this machine's file system, so the scene works only here.",
 "mesh { file: \"/home/me/scene/bunny.obj\" }",
 "mesh { file: \"bunny.obj\" }"},

{LRAY_CODE(W1701), "material or picture missing",
"A mesh file names a file with materials, a material or a picture that is not there or may not be "
"read. The mesh does without: what has no material of the file takes that of its block.",
"v 0 0 0\nv 1 0 0\nv 0 1 0\nmtllib chair.mtl\nusemtl oak\nf 1 2 3",
"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"},
{LRAY_CODE(W1702), "faces left out",
 "Some faces of the mesh have no area or repeat a vertex; they are left out.",
 "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2",
 "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"},
{LRAY_CODE(W1703), "picture with values that are no light",
 "Some values of a picture in floats are negative, not a number, infinite, or above 1e9. The "
 "first two are read as 0, the others as 1e9. Programs make such values when they sharpen or "
 "divide; save the picture with values from 0 on.",
 "environment { image: \"sky.exr\" }  // of which a pixel is infinite",
 "environment { image: \"sky.exr\" }"},
{LRAY_CODE(W1704), "not read from a file",
"The file has something that lray does not show: free-form curves and surfaces in a mesh, or "
"properties of a material that its models do not have. The rest is shown.",
"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ncurv 0 1 1 2 3",
"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"},
};
// clang-format on

#undef LRAY_CODE

constexpr bool is_indexed_by_code() {
    for (std::size_t i = 0; i < std::size(kInfos); ++i) {
        if (kInfos[i].code != static_cast<Code>(i)) return false;
    }
    return true;
}
static_assert(is_indexed_by_code(), "an entry is missing, doubled or out of order");
static_assert(std::size(kInfos) == kCodeCount, "the last codes have no entry");

char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

}  // namespace

std::span<const CodeInfo> code_infos() {
    return kInfos;
}

const CodeInfo& code_info(Code code) {
    const auto index = static_cast<std::size_t>(code);
    LRAY_ASSERT(index < std::size(kInfos));
    return kInfos[index];
}

std::optional<Code> find_code(std::string_view id) {
    for (const CodeInfo& info : kInfos) {
        const bool is_equal = std::equal(id.begin(), id.end(), info.id.begin(), info.id.end(),
                                         [](char a, char b) { return upper(a) == b; });
        if (is_equal) return info.code;
    }
    return std::nullopt;
}

std::string slug(const CodeInfo& info) {
    std::string result;
    bool is_gap = false;
    for (const char c : info.title) {
        const char letter = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        if ((letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9')) {
            if (is_gap && !result.empty()) result += '-';
            is_gap = false;
            result += letter;
        } else {
            is_gap = true;
        }
    }
    return result;
}

bool is_limit(Code code) {
    constexpr std::array kLimits = {Code::E0115, Code::E0511, Code::E0512, Code::E0513,
                                    Code::E0514, Code::E0515, Code::E0516, Code::E0517};
    return std::find(kLimits.begin(), kLimits.end(), code) != kLimits.end();
}

}  // namespace lray
