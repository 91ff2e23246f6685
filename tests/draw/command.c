#define _GNU_SOURCE // mkdtemp, realpath

#include "support/support.h"
#include "support/terminal.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

// A folder to work in ---------------------------------------------------------

static char folder[] = "/tmp/tanglefree-draw-XXXXXX";

/// Let the environment tell a path from the root.
static void tell_path(const char *name, const char *path)
{
    char whole[4096];
    ck_assert_msg(realpath(path, whole), "no %s at %s", name, path);
    ck_assert_int_eq(setenv(name, whole, 1), 0);
}

static void enter_folder(void)
{
    const char *draw = getenv("TANGLEFREE_DRAW"), *tf = getenv("TANGLEFREE");
    tell_path("TANGLEFREE_DRAW", draw ? draw : "build/tanglefree-draw");
    tell_path("TANGLEFREE", tf ? tf : "build/tanglefree");
    tell_path("QUERIES", "tests/queries");
    ck_assert(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
    ck_assert_int_eq(setenv("TMPDIR", folder, 1), 0);
}

static void leave_folder(void)
{
    ck_assert_int_eq(chdir("/"), 0);
    char line[64];
    snprintf(line, sizeof line, "rm -r %s", folder);
    ck_assert_int_eq(system(line), 0);
}

// Running the program ---------------------------------------------------------

typedef struct outcome {
    int status;
    char text[10000]; ///< standard output and standard error, mixed
} outcome;

/// Run a line of shell, in which `draw` is the program.
static outcome run(const char *format, va_list arguments)
{
    char line[2000];
    int length = snprintf(
        line, sizeof line,
        "exec 2>&1 </dev/null; draw() { \"$TANGLEFREE_DRAW\" \"$@\"; }\n");
    vsnprintf(line + length, sizeof line - (size_t)length, format, arguments);
    outcome found = {0};
    FILE *pipe = popen(line, "r");
    ck_assert_ptr_nonnull(pipe);
    found.text[fread(found.text, 1, sizeof found.text - 1, pipe)] = '\0';
    int status = pclose(pipe);
    ck_assert_msg(WIFEXITED(status), "%s: status %#x", line, (unsigned)status);
    found.status = WEXITSTATUS(status);
    return found;
}

/// Expect a line of shell to succeed; what it said, until the next call.
__attribute__((format(printf, 1, 2))) static const char *say(const char *format,
                                                             ...)
{
    static outcome found;
    va_list arguments;
    va_start(arguments, format);
    found = run(format, arguments);
    va_end(arguments);
    ck_assert_msg(found.status == 0, "%s: status %d\n%s", format, found.status,
                  found.text);
    return found.text;
}

/// Expect that a line of shell fails with status 2, says these words, and
/// leaves no file.
__attribute__((format(printf, 2, 3))) static void
refuse(const char *words, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    outcome found = run(format, arguments);
    va_end(arguments);
    ck_assert_msg(found.status == 2 && strstr(found.text, words),
                  "%s: status %d, not '%s' but:\n%s", format, found.status,
                  words, found.text);
    ck_assert_str_eq(say("ls -A"), "");
}

static void expect_words(const char *text, const char *words)
{
    ck_assert_msg(strstr(text, words), "'%s' is not in '%s'", words, text);
}

#define SMALL "--size 32x24"
#define QUERY "\"$QUERIES\"/point-edge.csv:0 --kind point-edge " SMALL " "
#define FIGURE "edge-sweep " SMALL " "

/// Make a triangle that lies, one that falls through it, and two that cross at
/// the end of that; a corner of the plane that turns over; and remove all that.
#define MESHES                                                                 \
    "lie='v 0 0 0\nv 4 0 0\nv 0 4 0\n'; "                                      \
    "printf \"${lie}"                                                          \
    "v 1 1 1\nv 2 1 2\nv 1 2 2\nf 1 2 3\nf 4 5 6\n\" >a.obj; "                 \
    "printf \"${lie}"                                                          \
    "v 1 1 -1\nv 2 1 1\nv 1 2 1\nf 1 2 3\nf 4 5 6\n\" >b.obj; "                \
    "printf 'v 0 0\nv 1 0\nv 0.5 1\nl 1 2\n' >p.obj; "                         \
    "printf 'v 0 0\nv 1 0\nv 0.5 -1\nl 1 2\n' >q.obj; "
/// Make the frames of a sheet of two triangles that bends above one that does
/// not, with velocities, in the folder f; and of a curve of the plane in g.
#define FRAMES                                                                 \
    "mkdir f g; for i in 0 1 2 3; do { printf 'ply\nformat ascii 1.0\n"        \
    "element vertex 7\n'; printf 'property double %%s\n' x y z vx vy vz; "     \
    "printf 'element face 3\nproperty list uchar int vertex_indices\n"         \
    "end_header\n'; for v in '0 0 1' '1 0 1' \"0 1 1.$i\" '1 1 1' '0 0 0' "    \
    "'1 0 0' '0 1 0'; do echo $v 0 0 0; done; printf '3 0 1 3\n3 0 3 2\n"      \
    "3 4 5 6\n'; } >f/frame-0000$i.ply; { printf 'ply\nformat ascii 1.0\n"     \
    "element vertex 4\nproperty double x\nproperty double y\nelement edge 2\n" \
    "property int vertex1\nproperty int vertex2\nend_header\n'; "              \
    "printf '0 0\n1 0\n0 1\n1 1.%%s\n0 1\n2 3\n' $i; } "                       \
    ">g/frame-0000$i.ply; done; "
#define CLEAR_FRAMES "; s=$?; rm -r f g; exit $s"

#define CLEAR "; s=$?; rm ?.obj; exit $s"

// Usage -----------------------------------------------------------------------

START_TEST(help_and_version_are_printed)
{
    expect_words(say("draw --help"), "list the figures");
    expect_words(say("draw figure --help"), "--animate");
    expect_words(say("draw figure --help"), "--panel");
    expect_words(say("draw query --help"), "FILE:N");
    expect_words(say("draw query --help"), "--at");
    expect_words(say("draw surface --help"), "START [END]");
    expect_words(say("draw film --help"), "with --every 3");
    expect_words(say("draw list --help"), "names and titles");
    const char *same = "test \"$(\"$TANGLEFREE\" --version | sed "
                       "'s/tanglefree/tanglefree-draw/')\" = \"$(draw %s)\"";
    static const char *const asked[] = {"--version",         "figure --version",
                                        "query --version",   "list --version",
                                        "surface --version", "film --version"};
    for (int i = 0; i < 6; i++) {
        char line[200];
        snprintf(line, sizeof line, same, asked[i]);
        say("%s", line);
    }
}
END_TEST

/// Nothing is printed but letters with several meanings.
START_TEST(a_letter_means_the_same_in_all_commands)
{
    const char *several =
        say("{ for c in query detect check resolve remesh simulate; do "
            "\"$TANGLEFREE\" $c --help; done; "
            "for c in figure query surface film list; do draw $c --help; done; "
            "} >helps; sed -n 's/^ *-\\(.\\), --\\([a-z-]*\\).*/\\1 \\2/p' "
            "helps >letters; sort -u letters | cut -c 1 | uniq -d; "
            "test $(wc -l <letters) -gt 50 && rm helps letters");
    ck_assert_str_eq(several, "");
}
END_TEST

START_TEST(old_letters_are_refused)
{
    refuse("tanglefree-draw figure: -t is an old spelling; write --theme",
           "draw figure " FIGURE "-o a.png -t dark");
    refuse("-t is an old spelling; write --theme",
           "draw film f -tdark -o a.webp");
    refuse("-m is an old spelling; write --motion",
           "draw surface a b -m bent -o a.png");
    refuse("-e is an old spelling; write --every",
           "draw film f -e 2 -o a.webp");
    refuse("-f is an old spelling; write --frame", "draw film f -f 2 -o a.png");
}
END_TEST

START_TEST(bad_commands_are_refused)
{
    refuse("a command is required; --help lists the commands", "draw");
    refuse("unknown command 'sketch'; --help lists the commands",
           "draw sketch");
    refuse("unexpected 'all'; list takes no", "draw list all");
    refuse("a figure is required; 'tanglefree-draw list' lists the figures",
           "draw figure -o a.png");
    refuse("unknown figure 'edge'; 'tanglefree-draw list' lists the figures",
           "draw figure edge -o a.png");
    refuse("draw one figure at a time", "draw figure edge-sweep edge-sweep");
    refuse("unrecognized option", "draw figure --colour red");
}
END_TEST

START_TEST(bad_settings_are_refused)
{
    static const struct {
        const char *words, *arguments;
    } bad[] = {
        {"--output FILE or --animate FILE is required: the picture or the film",
         ""},
        {"--output must end in .png, .pdf or .svg, got 'a.bmp'", "-o a.bmp"},
        {"must end in .png, .pdf or .svg", "-o png"},
        {"must end in .png, .pdf or .svg", "-o ./.png"},
        {"--animate must end in .mp4, .gif, .webp or .png, got 'a.bmp'",
         "--animate a.bmp"},
        {"--size must be width and height, such as", "-o a.png --size 0x0"},
        {"--size must be width and height, such as",
         "-o a.png --size 100000x100"},
        {"--size must be width and height, such as",
         "-o a.png --size 99999999999999999999x1"},
        {"--size must be width and height, such as", "-o a.png --size 800"},
        {"--size must be width and height, such as", "-o a.png --size -80x60"},
        {"--size must be width and height, such as", "-o a.png --size 80x60x"},
        {"both from 16 to 16384 pixels", "-o a.png --size 15x15"},
        {"or their ratio, such as 16:9", "-o a.png --size 16:"},
        {"--size must be width and height, such as", "-o a.png --size 16:0"},
        {"--size must be width and height, such as", "-o a.png --size 101:1"},
        {"--size must be width and height, such as", "-o a.png --size 4:3:2"},
        {"a picture must be from 16 to 16384 pixels", "-o a.png --size 1:100"},
        {"--title must be UTF-8 that closes each $, * and { and has \\$, \\* "
         "and "
         "\\\\ for the signs themselves, got '$x'",
         "-o a.png --title '$x'"},
        {"--panel must be an integer from 1 to ", "-o a.png --panel 0"},
        {"--panel: there is no panel 9; they are numbered from 1 to ",
         "-o a.png --panel 9"},
        {"there is no panel 9", "--animate a.png --turntable --panel 9"},
        {"--labels must be none", "-o a.png --labels q"},
        {"--dpi must be an integer from 1 to 4800, got '0'",
         "-o a.png --dpi 0"},
        {"--dpi must be an integer from 1 to 4800, got 'x'",
         "-o a.png --dpi x"},
        {"a picture must be from 16 to 16384 pixels", "-o a.png --dpi 1"},
        {"--theme must be light or dark, got 'pink'", "-o a.png --theme pink"},
        {"--view must be two angles in degrees", "-o a.png --view 30"},
        {"--view must be two angles in degrees", "-o a.png --view a,b"},
        {"--view must be two angles in degrees", "-o a.png --view 0,91"},
        {"--view must be two angles in degrees", "-o a.png --view 1e400,0"},
        {"--view must be two angles in degrees", "-o a.png --view 1,2,3"},
        {"--frames must be an integer from 1 to 10000, got '0'",
         "--animate a.gif --frames 0"},
        {"--fps must be an integer from 1 to 120, got '-1'",
         "--animate a.gif --fps -1"},
        {"an .mp4 file or a sheet cannot be transparent",
         "--animate a.mp4 --transparent"},
        {"an .mp4 file or a sheet cannot be transparent",
         "--animate a.png --transparent"},
        {"--turntable is for films", "-o a.png --turntable"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        refuse(bad[i].words, "draw figure edge-sweep %s", bad[i].arguments);
        refuse(bad[i].words,
               "draw query \"$QUERIES\"/edge-edge.csv:0 -k edge-edge %s",
               bad[i].arguments);
        refuse(bad[i].words, MESHES "draw surface a.obj %s" CLEAR,
               bad[i].arguments);
    }
}
END_TEST

START_TEST(bad_queries_are_refused)
{
    refuse("--labels must be none or 3 names, one a vertex, such as q,u,v, "
           "got 'p,a'",
           "draw query " QUERY "-o a.png --labels p,a");
    refuse("such as q,u,v, got 'p,,b'",
           "draw query " QUERY "-o a.png --labels p,,b");
    refuse("--labels must be UTF-8 that closes each $, ",
           "draw query " QUERY "-o a.png --labels p_{,a,b");
    refuse("--at must be from 0 to 1, got '2'",
           "draw query " QUERY "-o a.png --at 2");
    refuse("--at is for pictures; add -o",
           "draw query " QUERY "--animate a.gif --at 0.5");
    refuse("a query is required: FILE:N", "draw query -k edge-edge -o a.png");
    refuse("--kind KIND is required", "draw query x:0 -o a.png");
    refuse("--kind must be point-edge", "draw query x:0 -k knot -o a.png");
    refuse("a query must be FILE:N, where N is its number in the file, from 0, "
           "got 'x'",
           "draw query x -k edge-edge -o a.png");
    refuse("from 0, got 'x:-1'", "draw query x:-1 -k edge-edge -o a.png");
    refuse("from 0, got 'x:1y'", "draw query x:1y -k edge-edge -o a.png");
    refuse("from 0, got 'x:99999999999999999999'",
           "draw query x:99999999999999999999 -k edge-edge -o a.png");
    refuse("draw one query at a time",
           "draw query x:0 y:0 -k edge-edge -o a.png");
    refuse("tanglefree-draw: x: cannot open: ",
           "draw query x:0 -k edge-edge -o a.png");
    refuse("point-edge.csv: there is no query 7; they are numbered from 0 to "
           "6",
           "draw query \"$QUERIES\"/point-edge.csv:7 -k point-edge -o a.png");
    refuse("tanglefree-draw: /dev/stdin:2: column 1 is 'x'",
           "printf '0,0\\nx,0\\n' | draw query /dev/stdin:0 -k point-edge -o "
           "a.png");
}
END_TEST

START_TEST(bad_surfaces_are_refused)
{
    refuse("a surface is required: its file", "draw surface -o a.png");
    refuse("unexpected 'c'; give one START and one END",
           "draw surface a b c -o a.png");
    refuse("--motion must be bent or straight, got 'wild'",
           "draw surface a b --motion wild -o a.png");
    refuse("--up must be x, y or z, got 'w'", "draw surface a -u w -o a.png");
    refuse("--up must be x, y or z, got ''", "draw surface a -u '' -o a.png");
    refuse("--at must be from 0 to 1, got '1.5'",
           "draw surface a b --time 1.5 -o a.png");
    refuse("--at must be from 0 to 1, got 'x'",
           "draw surface a b --time x -o a.png");
    refuse("--at is for steps; add END", "draw surface a --time 0.5 -o a.png");
    refuse("--crossings is for a surface at rest; drop END, or write "
           "--contacts",
           "draw surface a b --crossings -o a.png");
    refuse("--contacts and --crossings exclude each other; drop one",
           "draw surface a -c --crossings -o a.png");
    refuse("--motion is for steps", "draw surface a --motion bent -o a.png");
    refuse("nothing moves without END; add it, or --turntable",
           "draw surface a --animate a.gif");
    refuse("cannot be turned; drop --turntable",
           MESHES "draw surface p.obj --turntable --animate a.gif" CLEAR);
}
END_TEST

START_TEST(bad_meshes_are_refused)
{
    refuse("tanglefree-draw: x.obj: cannot open: ",
           "draw surface x.obj -o a.png");
    refuse("tanglefree-draw: /dev/stdin:2: ",
           "printf 'v 0 0 0\nv 1 x 0\n' | draw surface /dev/stdin -o a.png");
    refuse("tanglefree-draw: q.obj: 3 vertices, but a.obj has 6; all files "
           "must have "
           "the same elements",
           MESHES "draw surface a.obj q.obj -o a.png" CLEAR);
    refuse("standard input:4: there is no vertex 9; they are numbered from 1 "
           "to 3",
           "printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' | "
           "draw surface - -o a.png");
    refuse("no triangles and no edges; a mesh must",
           "printf 'v 0 0 0\n' | draw surface - -o a.png");
    refuse("no/a.png: there is no folder 'no'; make it",
           MESHES "draw surface a.obj " SMALL " -o no/a.png" CLEAR);
}
END_TEST

START_TEST(bad_films_are_refused)
{
    refuse("a folder is required: one that 'tanglefree simulate' wrote",
           "draw film -o a.webp");
    refuse("unexpected 'b'; draw one film at a time",
           "draw film a b -o a.webp");
    refuse("--up must be x, y or z, got 'w'", "draw film a -u w -o a.webp");
    refuse("--output FILE is required: the film or the picture", "draw film a");
    refuse(
        "--output must end in .webp, .gif or .mp4, in .png, .pdf or .svg, or "
        "in / for a folder, got 'a.bmp'",
        "draw film a -o a.bmp");
    refuse("--every must be an integer from 1 to ",
           "draw film a -o a.webp --every 0");
    refuse("--frame must be an integer from 0 to ",
           "draw film a -o a.png --frame -1");
    refuse("--frame is for pictures; drop it",
           "draw film a -o a.webp --frame 1");
    refuse("--every is for films; drop it", "draw film a -o a.png --every 2");
    refuse("unrecognized option", "draw film a -o a.webp --turntable");
    refuse("--size must be width and height, such as",
           "draw film a -o a.webp --size 1x1");
}
END_TEST

START_TEST(bad_frames_are_refused)
{
    refuse("tanglefree-draw: x: cannot open: No such file or directory; give "
           "the folder that 'tanglefree simulate' wrote",
           "draw film x -o a.webp");
    refuse("tanglefree-draw: f: no frames frame-00000.ply, frame-00001.ply, "
           "...; give the folder",
           "mkdir f; touch f/frame-0.ply f/frame-00000.obj f/frame-00000.ply~; "
           "draw film f -o a.webp; s=$?; rm -r f; exit $s");
    refuse("tanglefree-draw: f/frame-00001.ply: there is no such frame, but "
           "there is frame-00003.ply; simulate again, or number",
           FRAMES "rm f/*1.ply; draw film f -o a.webp" CLEAR_FRAMES);
    refuse("tanglefree-draw: f/frame-00000.ply: there is no such frame",
           FRAMES "rm f/*0.ply; draw film f -o a.webp" CLEAR_FRAMES);
    refuse("tanglefree-draw: f/frame-00002.ply: 4 vertices, but "
           "f/frame-00001.ply has 7; all files must have the same",
           FRAMES "cp g/*2.ply f; draw film f -o a.webp" CLEAR_FRAMES);
    refuse("tanglefree-draw: f/frame-00003.ply:16: 'x' is not a finite",
           FRAMES "sed 's/^1 1 1/1 x 1/' f/*0.ply >f/frame-00003.ply; "
                  "draw film f -o a.webp" CLEAR_FRAMES);
    refuse("tanglefree-draw: f: there is no frame 4; they are "
           "numbered from 0 to 3",
           FRAMES "draw film f -o a.png --frame 4" CLEAR_FRAMES);
    refuse("no/a.png: there is no folder 'no'; make it",
           FRAMES "draw film f " SMALL " -o no/a.png" CLEAR_FRAMES);
    refuse("no/a.webp: there is no folder 'no'; make it",
           FRAMES "draw film f " SMALL " -o no/a.webp" CLEAR_FRAMES);
    refuse("no/a/: there is no folder 'no'; make it",
           FRAMES "draw film f " SMALL " -o no/a/" CLEAR_FRAMES);
    refuse("tanglefree-draw: a\\x1b[2J: cannot open: ",
           "draw film \"$(printf 'a\033[2J')\" -o a.png");
}
END_TEST

// Files -----------------------------------------------------------------------

START_TEST(outputs_that_cannot_be_written_are_refused)
{
    refuse("no/a.png: there is no folder 'no'; make it, or choose "
           "another",
           "draw figure " FIGURE "-o no/a.png");
    refuse("no/a.gif: there is no folder 'no'; make it",
           "draw figure " FIGURE "--animate "
           "no/a.gif");
    refuse("a.png: cannot write: ",
           "mkdir a.png; draw figure " FIGURE "-o a.png; s=$?; rmdir a.png; "
           "exit $s");
    refuse("standard output: cannot write: ",
           "draw query " QUERY "-o a.png >/dev/full; s=$?; rm a.png; exit $s");
    refuse("standard output: cannot write: ", "draw list >/dev/full");
    refuse("standard output: cannot write: ", "draw --version >/dev/full");
    refuse("standard output: cannot write: ", "draw query --help >/dev/full");
}
END_TEST

START_TEST(names_send_no_commands_to_the_terminal)
{
    refuse("tanglefree-draw: a\\x1b[2J: cannot open: ",
           "draw query \"$(printf 'a\\033[2J'):0\" -k edge-edge -o a.png");
    refuse("a\\x1b[2J/a.png: there is no folder 'a\\x1b[2J'; make it",
           "draw figure " FIGURE "-o \"$(printf 'a\\033[2J')/a.png\"");
    static const char *const words[] = {"%s",
                                        "figure %s -o a.png",
                                        "figure edge-sweep -o %s",
                                        "figure edge-sweep -o a.png --size %s",
                                        "figure edge-sweep -o a.png --view %s",
                                        "figure edge-sweep -o a.png --theme %s",
                                        "figure edge-sweep -o a.png --dpi %s",
                                        "query %s -k edge-edge -o a.png",
                                        "query a:0 -k %s -o a.png",
                                        "surface a b %s -o a.png",
                                        "surface a b --motion %s -o a.png",
                                        "surface a b -u %s -o a.png",
                                        "surface a b -T %s -o a.png",
                                        "film a %s -o a.png",
                                        "film a -o %s",
                                        "film a -o a.png --frame %s",
                                        "list %s"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        char line[100];
        snprintf(line, sizeof line, words[i], "\"$(printf '\\033c')\"");
        refuse("'\\x1bc'", "draw %s", line);
    }
}
END_TEST

START_TEST(missing_glyphs_are_refused)
{
    refuse(
        "the font is not installed",
        "mkdir cache; printf '<fontconfig><cachedir>cache</cachedir>"
        "</fontconfig>' >fonts; FONTCONFIG_FILE=$PWD/fonts draw figure " FIGURE
        "-o a.png; s=$?; rm -r fonts cache; exit $s");
}
END_TEST

/// A stop in the middle of a film leaves nothing.
START_TEST(a_signal_leaves_no_file)
{
    say("command -v ffmpeg >/dev/null || exit 0\n"
        "\"$TANGLEFREE_DRAW\" figure " FIGURE "--animate a.gif --frames 9999 &"
        " sleep 0.5; kill $!; wait $!; test $? -gt 128");
    ck_assert_str_eq(say("ls -A"), "");
}
END_TEST

START_TEST(pictures_are_the_same_every_time)
{
    static const struct {
        const char *ending, *start;
    } kinds[] = {{"png", "\\211PNG"}, {"pdf", "%PDF"}, {"svg", "<?xml"}};
    for (int i = 0; i < 3; i++) {
        const char *ending = kinds[i].ending;
        say("for n in 1 2; do draw figure " FIGURE "-o a$n.%s || exit 1; done; "
            "cmp a1.%s a2.%s",
            ending, ending, ending);
        say("for n in 1 2; do draw query " QUERY "-o b$n.%s || exit 1; done; "
            "cmp b1.%s b2.%s",
            ending, ending, ending);
        say(MESHES "for n in 1 2; do draw surface a.obj b.obj -c " SMALL
                   " -o c$n.%s || exit 1; done; cmp c1.%s c2.%s; rm ?.obj",
            ending, ending, ending);
        say("head -c 5 a1.%s | grep -a \"^$(printf '%s')\"", ending,
            kinds[i].start);
    }
    say("draw figure " FIGURE "--theme dark -x -v 30,-20 -o a2.png");
    say("! cmp a1.png a2.png");
    ck_assert_str_eq(say("umask 027; draw figure " FIGURE "-o c.png >d; "
                         "stat -c %%a c.png; ls -A | grep '^\\.'; true"),
                     "640\n");
}
END_TEST

START_TEST(the_resolution_determines_the_size)
{
    // Bytes 17 to 24 of a PNG are its width and height.
    ck_assert_str_eq(say("draw query \"$QUERIES\"/point-edge.csv:0 -k "
                         "point-edge --dpi 18 -o a.png >b; "
                         "od -An -tu1 -j16 -N8 a.png"),
                     "   0   0   0  96   0   0   0  72\n");

    // With a size it is only recorded: 254 pixels an inch are 10000 a meter, in
    // the chunk pHYs that follows the chunks IHDR and sRGB.
    ck_assert_str_eq(say("draw figure " FIGURE "--dpi 254 -o a.png >b; "
                         "od -An -tu1 -j54 -N4 a.png; "
                         "od -An -c -j50 -N4 a.png"),
                     "   0   0  39  16\n   p   H   Y   s\n");
}
END_TEST

/// A pixel of a vector file is 1/96 inch, 3/4 of a point, unless --dpi tells.
START_TEST(sizes_hold_for_vectors)
{
    static const struct {
        const char *options, *width, *height;
    } sizes[] = {{"--size 800x450", "600", "337.5"},
                 {"--size 450x800 --dpi 72", "450", "800"},
                 {"--size 16:9", "384", "216"},
                 {"--dpi 300", "384", "288"},
                 {"", "384", "288"}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        say("draw query \"$QUERIES\"/point-edge.csv:0 -k point-edge -o a.svg "
            "%s "
            "&& draw query \"$QUERIES\"/point-edge.csv:0 -k point-edge -o "
            "a.pdf "
            "%s && grep -q 'width=\"%spt\" height=\"%spt\"' a.svg && "
            "grep -aq '/MediaBox \\[ 0 0 %s %s \\]' a.pdf",
            sizes[i].options, sizes[i].options, sizes[i].width, sizes[i].height,
            sizes[i].width, sizes[i].height);
    }
}
END_TEST

/// The width and height of a.png as drawn with these options.
static void expect_size(const char *options, int width, int height)
{
    int bytes[8];
    say("draw query \"$QUERIES\"/point-edge.csv:0 -k point-edge -o a.png %s",
        options);
    const char *text = say("od -An -tu1 -j16 -N8 a.png");
    ck_assert_int_eq(sscanf(text, "%d %d %d %d %d %d %d %d", &bytes[0],
                            &bytes[1], &bytes[2], &bytes[3], &bytes[4],
                            &bytes[5], &bytes[6], &bytes[7]),
                     8);
    int found[2] = {256 * bytes[2] + bytes[3], 256 * bytes[6] + bytes[7]};
    ck_assert_msg(found[0] == width && found[1] == height, "%s: %d x %d",
                  options, found[0], found[1]);
}

START_TEST(pictures_grow_with_what_is_added)
{
    expect_size("--dpi 72", 384, 288);
    expect_size("--dpi 72 --size 16:9", 384, 216);
    expect_size("--size 16:9", 1600, 900);
    expect_size("--dpi 72 --title 'A $t$'", 384, 322);
    // The head of the table, three vertices, contact, normal, and a note.
    expect_size("--dpi 72 --coordinates", 384, 288 + 7 * 13 + 8);
    expect_size("--dpi 72 --title A --coordinates --size 400x100", 400, 100);
}
END_TEST

START_TEST(panels_titles_and_labels_show)
{
    static const char *const options[] = {"",
                                          "--title A",
                                          "--title B",
                                          "--panel 1",
                                          "--panel 2",
                                          "--labels none",
                                          "--labels q,a,b",
                                          "--at 0.25",
                                          "--at 0.375",
                                          "--coordinates",
                                          "--panel 1 --theme dark"};
    enum {
        COUNT = sizeof options / sizeof *options
    };
    for (int i = 0; i < COUNT; i++)
        say("draw query \"$QUERIES\"/point-edge.csv:0 -k point-edge --size "
            "160x120 -o %d.png %s",
            i, options[i]);
    for (int i = 0; i < COUNT; i++)
        for (int j = 0; j < i; j++)
            say("! cmp %d.png %d.png", i, j);
    say("draw query \"$QUERIES\"/point-edge.csv:0 -k point-edge --size 160x120 "
        "-o a.png --labels p,a,b && cmp a.png 0.png");
    say("draw query \"$QUERIES\"/point-edge.csv:0 -k point-edge --size 160x120 "
        "-o a.png --time 0.25 && cmp a.png 7.png");
    say(FRAMES "draw film f " SMALL " -o p.png && draw film f " SMALL
               " -o q.png --title A && ! cmp p.png q.png; "
               "s=$?; rm -r f g; exit $s");
}
END_TEST

START_TEST(progress_is_shown_on_a_terminal)
{
    terminal screen = terminal_open();
    say("timeout 3 \"$TANGLEFREE_DRAW\" figure " FIGURE "--frames 9999 "
        "--animate a.png 2>%s; test $? = 124",
        screen.name);
    const char *shown = terminal_close(&screen);
    expect_words(shown, " of 9999 frames [");
}
END_TEST

START_TEST(figures_without_motion_make_no_film)
{
    refuse("nothing in 'prism' moves; add --turntable",
           "draw figure prism --animate a.gif");
}
END_TEST

START_TEST(figures_are_listed_and_print_their_numbers)
{
    expect_words(say("draw list"), "edge-sweep ");
    expect_words(say("draw figure " FIGURE "-o a.png"), "toi_hi 0.");
}
END_TEST

START_TEST(queries_print_the_numbers_of_tanglefree)
{
    static const char *const kinds[] = {"point-edge", "point-triangle",
                                        "edge-edge"};
    for (int i = 0; i < 3; i++)
        say("\"$TANGLEFREE\" query --kind %s \"$QUERIES\"/%s.csv | "
            "sed 1d | while IFS=, read -r n hit lo hi rest; do "
            "draw query \"$QUERIES\"/%s.csv:$n -k %s " SMALL " -o a.png >told "
            "&& grep -x \"hit $hit\" told || exit 1; done",
            kinds[i], kinds[i], kinds[i], kinds[i]);
}
END_TEST

/// The contacts of detection, and their first time; what a check finds.
START_TEST(surfaces_print_the_rows_of_tanglefree)
{
    static const char *const steps[] = {"a.obj b.obj", "p.obj q.obj",
                                        "a.obj a.obj"};
    for (int i = 0; i < 3; i++)
        say(MESHES "draw surface %s -c " SMALL " -o a.png >told || exit 1; "
                   "\"$TANGLEFREE\" detect %s | sed 1d >rows; "
                   "grep -x \"contacts $(wc -l <rows)\" told && "
                   "first=$(cut -d, -f7 rows | sort -g | head -n 1) && "
                   "{ [ -z \"$first\" ] || awk -v first=\"$first\" '"
                   "$1 == \"toi_lo\" && $2 == first { found = 1 } "
                   "END { exit !found }' told; }",
            steps[i], steps[i]);
    static const char *const files[] = {"a.obj", "b.obj"};
    for (int i = 0; i < 2; i++)
        say(MESHES "draw surface %s -c " SMALL " -o a.png >told || exit 1; "
                   "\"$TANGLEFREE\" check %s | sed 1d >rows; "
                   "grep -x \"intersections $(wc -l <rows)\" told",
            files[i], files[i]);
}
END_TEST

START_TEST(surfaces_print_their_counts)
{
    ck_assert_str_eq(
        say(MESHES "draw surface a.obj b.obj --contacts " SMALL " -o a.png"),
        "vertices 6\ntriangles 2\nedges 6\nparts 2\n"
        "time 0.5\ncontacts 1\n"
        "toi_lo 0.4999999999999997\n"
        "toi_hi 0.5000000000000002\n");
    expect_words(say(MESHES "draw surface a.obj b.obj " SMALL " -o a.png"),
                 "time 1\n");
    expect_words(
        say(MESHES "draw surface a.obj b.obj --time 0.25 " SMALL " -o a.png"),
        "time 0.25\n");
    ck_assert_ptr_null(
        strstr(say(MESHES "draw surface a.obj " SMALL " -o a.png"), "time"));
    say(MESHES
        "for m in bent straight; do draw surface a.obj b.obj --motion $m "
        "--time 0.3 " SMALL " -o $m.png || exit 1; done; "
        "! cmp bent.png straight.png");
    say(MESHES "for u in x y z; do draw surface a.obj -u $u " SMALL
               " -o u$u.png || exit 1; done; ! cmp ux.png uy.png && "
               "! cmp uy.png uz.png");
}
END_TEST

START_TEST(surfaces_print_their_curves_and_zones)
{
    const char *text = say(MESHES "draw surface b.obj --crossings " SMALL
                                  " -o a.png && draw surface b.obj " SMALL
                                  " -o b.png >told; ! cmp -s a.png b.png");
    ck_assert_str_eq(text, "vertices 6\ntriangles 2\nedges 6\nparts 2\n"
                           "intersections 2\ncurves 1\nzones 1\n");
    expect_words(
        say(MESHES "draw surface a.obj --crossings " SMALL " -o a.png"),
        "intersections 0\ncurves 0\nzones 0\n");
    // Two edges of the plane that cross, and one beside them.
    expect_words(say("printf 'v 0 0\nv 2 2\nv 0 2\nv 2 0\nv 3 0\nv 9 9\nv 9 8\n"
                     "l 1 2\nl 3 4\nl 4 5\nl 6 7\n' >x.obj; draw surface x.obj "
                     "--crossings " SMALL " -o a.png"),
                 "intersections 1\ncurves 0\nzones 1\n");
    say(MESHES "for t in light dark; do draw surface b.obj --crossings "
               "--theme $t --turntable --frames 2 --size 32x24 --animate "
               "$t.png || exit 1; done; ! cmp -s light.png dark.png");
}
END_TEST

// Films -----------------------------------------------------------------------

START_TEST(a_missing_ffmpeg_is_reported)
{
    refuse("cannot run ffmpeg, which makes the film: No such file or directory;"
           " install it",
           "PATH=/nowhere; draw figure " FIGURE "--animate a.mp4");
    refuse("ffmpeg failed; see its message",
           "mkdir bin; printf '#!/bin/sh\\nexit 1\\n' >bin/ffmpeg; "
           "chmod +x bin/ffmpeg; PATH=$PWD/bin:$PATH; draw figure " FIGURE
           "--animate a.mp4 --frames 1; s=$?; rm -r bin; exit $s");
}
END_TEST

/// On a disk of 16 kB; without the right to make one, nothing is tried.
START_TEST(a_full_disk_leaves_no_film)
{
    static const char *const endings[] = {"mp4", "gif", "webp"};
    bool able = *say("command -v ffmpeg >at && unshare -rm mount -t tmpfs none "
                     ". 2>at && echo able; rm at");
    for (int i = 0; i < 3 && able; i++)
        refuse("ffmpeg failed",
               "mkdir full; unshare -rm sh -c '"
               "mount -t tmpfs -o size=16k none full || exit 77; "
               "\"$TANGLEFREE_DRAW\" figure edge-sweep --size 320x240 --frames "
               "30 --animate full/a.%s; status=$?; "
               "[ -z \"$(ls -A full)\" ] || exit 1; exit $status'; "
               "status=$?; rmdir full; exit $status",
               endings[i]);
}
END_TEST

START_TEST(films_are_made)
{
    static const char *const endings[] = {"mp4", "gif", "webp"};
    for (int i = 0; i < 3; i++) {
        const char *ending = endings[i];
        say("command -v ffmpeg >/dev/null || exit 0\n"
            "draw query " QUERY "--frames 3 --fps 10 --animate a.%s && "
            "draw figure " FIGURE "--frames 2 --turntable --animate b.%s && "
            "test -s a.%s -a -s b.%s && " MESHES
            "draw surface a.obj b.obj " SMALL " --frames 3 -c --animate c.%s &&"
            " draw surface a.obj " SMALL " --frames 2 --turntable --animate "
            "d.%s && draw surface p.obj q.obj " SMALL " --frames 2 --animate "
            "e.%s && test -s c.%s -a -s d.%s -a -s e.%s && rm ?.obj",
            ending, ending, ending, ending, ending, ending, ending, ending,
            ending, ending);
    }
    say("command -v ffprobe >/dev/null || exit 0\n"
        "ffprobe -loglevel error -count_frames -show_entries "
        "stream=width,height,nb_read_frames -of csv=p=0 a.mp4 | "
        "grep -x 32,24,3");
    ck_assert_str_eq(say("ls -A | grep '^\\.'; true"), "");
}
END_TEST

/// The frames of a simulation, as films, as pictures and as one picture.
START_TEST(frames_are_drawn)
{
    ck_assert_str_eq(say(FRAMES "draw film f " SMALL " -o f/"),
                     "frames 4\nvertices 7\ntriangles 3\nedges 8\nparts 2\n"
                     "stiff_parts 1\n");
    say("test \"$(echo f/*.png)\" = \"f/frame-00000.png f/frame-00001.png "
        "f/frame-00002.png f/frame-00003.png\"");
    say("! cmp f/frame-00000.png f/frame-00003.png");
    expect_words(say("draw film g " SMALL " -o p/ --every 2"),
                 "frames 2\nvertices 4\n");
    say("test \"$(ls p)\" = \"frame-00000.png\nframe-00001.png\"");
    expect_words(say("draw film g " SMALL " -o p/ --every 99"), "frames 1\n");
    say("draw film f " SMALL " -o p.png --frame 0 && draw film f " SMALL
        " -o q.png && draw film f " SMALL " -v 90,10 --theme dark -o r.png && "
        "! cmp p.png q.png && ! cmp q.png r.png");
    say("draw film f --size 32x48 -o p.png && od -An -tu1 -j16 -N8 p.png | "
        "grep -x '   0   0   0  32   0   0   0  48'");
    static const char *const endings[] = {"mp4", "gif", "webp"};
    for (int i = 0; i < 3; i++)
        say("command -v ffmpeg >/dev/null || exit 0\n"
            "draw film f " SMALL " --fps 10 -o f.%s && test -s f.%s",
            endings[i], endings[i]);
    ck_assert_str_eq(say("ls -A | grep '^\\.'; rm -r ?; true"), "");
}
END_TEST

/// What frames say of themselves, which --up overrules.
START_TEST(frames_name_their_obstacles_and_what_is_up)
{
    say(FRAMES "draw film f " SMALL " -o z.png && draw film f " SMALL
               " -o y.png --up y && ! cmp z.png y.png");
    say("sed -i '2a comment up y' f/*0.ply && draw film f " SMALL
        " -o p.png && draw film f " SMALL " -o q.png --up z && "
        "cmp p.png y.png && cmp q.png z.png");
    expect_words(say("sed -i '2a comment mesh of 4 vertices, scripted: a\\n"
                     "comment mesh of 3 vertices, moving: b' f/*0.ply && "
                     "draw film f " SMALL " -o r.png && ! cmp p.png r.png"),
                 "parts 2\nstiff_parts 1\n");
    expect_words(
        say("sed -i 's/moving: b/fixed: b/' f/*0.ply && draw film f " SMALL
            " -o r.png && cmp p.png r.png"),
        "stiff_parts 1\n");
    expect_words(
        say("sed -i 's/mesh of 3/mesh of 2/' f/*0.ply && draw film f " SMALL
            " -o r.png && cmp p.png r.png"),
        "stiff_parts 1\n");
    say("rm -r ? ?.png");
}
END_TEST

START_TEST(a_sheet_has_all_frames_and_is_the_same_every_time)
{
    say("draw figure " FIGURE "--frames 7 --animate a.png && "
        "draw figure " FIGURE "--frames 7 --animate b.png && "
        "cmp a.png b.png && test \"$(grep -ac '32 24 32 32 7$' a.png)\" = 1 "
        "|| { head -c 90 a.png; exit 1; }");
    ck_assert_str_eq(say("ls -A | grep '^\\.'; true"), "");
}
END_TEST

Suite *suite(void)
{
    const TTest *const tests[] = {
        help_and_version_are_printed,
        a_letter_means_the_same_in_all_commands,
        old_letters_are_refused,
        bad_commands_are_refused,
        bad_settings_are_refused,
        bad_queries_are_refused,
        bad_surfaces_are_refused,
        bad_meshes_are_refused,
        outputs_that_cannot_be_written_are_refused,
        names_send_no_commands_to_the_terminal,
        missing_glyphs_are_refused,
        a_signal_leaves_no_file,
        pictures_are_the_same_every_time,
        the_resolution_determines_the_size,
        sizes_hold_for_vectors,
        pictures_grow_with_what_is_added,
        panels_titles_and_labels_show,
        progress_is_shown_on_a_terminal,
        figures_are_listed_and_print_their_numbers,
        queries_print_the_numbers_of_tanglefree,
        surfaces_print_the_rows_of_tanglefree,
        surfaces_print_their_counts,
        surfaces_print_their_curves_and_zones,
        a_missing_ffmpeg_is_reported,
        a_full_disk_leaves_no_film,
        films_are_made,
        a_sheet_has_all_frames_and_is_the_same_every_time,
        figures_without_motion_make_no_film,
        bad_films_are_refused,
        bad_frames_are_refused,
        frames_are_drawn,
        frames_name_their_obstacles_and_what_is_up,
    };
    Suite *s = suite_create("draw/command");
    TCase *command = tcase_create("command");
    tcase_add_checked_fixture(command, enter_folder, leave_folder);
    for (size_t i = 0; i < sizeof tests / sizeof *tests; i++)
        tcase_add_test(command, tests[i]);
    suite_add_tcase(s, command);
    return s;
}
