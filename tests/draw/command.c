#define _GNU_SOURCE // mkdtemp, realpath

#include "support/support.h"

#include <stdarg.h>
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

// Usage -----------------------------------------------------------------------

START_TEST(help_and_version_are_told)
{
    expect_words(say("draw --help"), "list the figures");
    expect_words(say("draw figure --help"), "--animate");
    expect_words(say("draw query --help"), "FILE:N");
    expect_words(say("draw list --help"), "names and titles");
    const char *same = "test \"$(\"$TANGLEFREE\" --version | sed "
                       "'s/tanglefree/tanglefree-draw/')\" = \"$(draw %s)\"";
    static const char *const asked[] = {"--version", "figure --version",
                                        "query --version", "list --version"};
    for (int i = 0; i < 4; i++) {
        char line[200];
        snprintf(line, sizeof line, same, asked[i]);
        say("%s", line);
    }
}
END_TEST

START_TEST(commands_are_refused)
{
    refuse("a command is missing; choose", "draw");
    refuse("no command is named 'sketch'; choose figure, list or query",
           "draw sketch");
    refuse("'all' is too much", "draw list all");
    refuse("a figure is missing", "draw figure -o a.png");
    refuse("no figure is named 'edge'; choose one of ",
           "draw figure edge -o a.png");
    refuse("one figure too many", "draw figure edge-sweep edge-sweep");
    refuse("unrecognized option", "draw figure --colour red");
}
END_TEST

START_TEST(settings_are_refused)
{
    static const struct {
        const char *words, *arguments;
    } bad[] = {
        {"nothing to write; name a file by -o", ""},
        {"must end in .png, .pdf or .svg", "-o a.bmp"},
        {"must end in .png, .pdf or .svg", "-o png"},
        {"must end in .png, .pdf or .svg", "-o ./.png"},
        {"must end in .mp4, .gif or .webp", "--animate a.png"},
        {"the size is '0x0'", "-o a.png --size 0x0"},
        {"the size is '100000x100'", "-o a.png --size 100000x100"},
        {"the size is '99999999999999999999x1'",
         "-o a.png --size 99999999999999999999x1"},
        {"the size is '800'", "-o a.png --size 800"},
        {"the size is '-80x60'", "-o a.png --size -80x60"},
        {"the size is '80x60x'", "-o a.png --size 80x60x"},
        {"both from 16 to 16384 pixels", "-o a.png --size 15x15"},
        {"--dpi is '0'; give a number from 1", "-o a.png --dpi 0"},
        {"--dpi is 'x'", "-o a.png --dpi x"},
        {"a picture is 16 to 16384 pixels", "-o a.png --dpi 1"},
        {"no theme is named 'pink'; choose light or dark",
         "-o a.png --theme pink"},
        {"the view is '30'; give two angles", "-o a.png --view 30"},
        {"the view is 'a,b'", "-o a.png --view a,b"},
        {"the view is '0,91'", "-o a.png --view 0,91"},
        {"the view is '1e400,0'", "-o a.png --view 1e400,0"},
        {"the view is '1,2,3'", "-o a.png --view 1,2,3"},
        {"--frames is '0'", "--animate a.gif --frames 0"},
        {"--fps is '-1'", "--animate a.gif --fps -1"},
        {"no .mp4 is transparent", "--animate a.mp4 --transparent"},
        {"--turntable is for films", "-o a.png --turntable"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        refuse(bad[i].words, "draw figure edge-sweep %s", bad[i].arguments);
        refuse(bad[i].words,
               "draw query \"$QUERIES\"/edge-edge.csv:0 -k edge-edge %s",
               bad[i].arguments);
    }
}
END_TEST

START_TEST(queries_are_refused)
{
    refuse("a query is missing", "draw query -k edge-edge -o a.png");
    refuse("--kind is missing", "draw query x:0 -o a.png");
    refuse("no kind is named 'knot'; choose point-edge",
           "draw query x:0 -k knot -o a.png");
    refuse("'x' names no query; write FILE:N",
           "draw query x -k edge-edge -o a.png");
    refuse("'x:-1' names no query", "draw query x:-1 -k edge-edge -o a.png");
    refuse("'x:1y' names no query", "draw query x:1y -k edge-edge -o a.png");
    refuse("'x:99999999999999999999' names no query",
           "draw query x:99999999999999999999 -k edge-edge -o a.png");
    refuse("one query too many", "draw query x:0 y:0 -k edge-edge -o a.png");
    refuse("tanglefree-draw: x: cannot open: ",
           "draw query x:0 -k edge-edge -o a.png");
    refuse("point-edge.csv: query 7 is beyond the end; the file has 7, from 0 "
           "to 6",
           "draw query \"$QUERIES\"/point-edge.csv:7 -k point-edge -o a.png");
    refuse("tanglefree-draw: /dev/stdin:2: column 1 is \"x\"",
           "printf '0,0\\nx,0\\n' | draw query /dev/stdin:0 -k point-edge -o "
           "a.png");
}
END_TEST

// Files -----------------------------------------------------------------------

START_TEST(outputs_that_cannot_be_written_are_refused)
{
    refuse("no/a.png: cannot write: No such file or directory; name a file",
           "draw figure " FIGURE "-o no/a.png");
    refuse("no/a.gif: cannot write: ", "draw figure " FIGURE "--animate "
                                       "no/a.gif");
    refuse("a.png: cannot write: ",
           "mkdir a.png; draw figure " FIGURE "-o a.png; s=$?; rmdir a.png; "
           "exit $s");
    refuse("standard output: cannot write: ",
           "draw query " QUERY "-o a.png >/dev/full; s=$?; rm a.png; exit $s");
    refuse("standard output: cannot write: ", "draw list >/dev/full");
}
END_TEST

START_TEST(missing_letters_are_refused)
{
    refuse(
        "the family of letters is not installed",
        "mkdir cache; printf '<fontconfig><cachedir>cache</cachedir>"
        "</fontconfig>' >fonts; FONTCONFIG_FILE=$PWD/fonts draw figure " FIGURE
        "-o a.png; s=$?; rm -r fonts cache; exit $s");
}
END_TEST

/// A stop in the middle of a film leaves nothing.
START_TEST(signals_leave_no_file)
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
        say("head -c 5 a1.%s | grep -a \"^$(printf '%s')\"", ending,
            kinds[i].start);
    }
    say("draw figure " FIGURE "-t dark -x -v 30,-20 -o a2.png");
    say("! cmp a1.png a2.png");
    ck_assert_str_eq(say("umask 027; draw figure " FIGURE "-o c.png >d; "
                         "stat -c %%a c.png; ls -A | grep '^\\.'; true"),
                     "640\n");
}
END_TEST

START_TEST(resolution_tells_the_size)
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

START_TEST(films_show_what_moves)
{
    refuse("nothing moves in 'prism'; add --turntable",
           "draw figure prism --animate a.gif");
}
END_TEST

START_TEST(figures_are_listed_and_tell_their_numbers)
{
    expect_words(say("draw list"), "edge-sweep ");
    expect_words(say("draw figure " FIGURE "-o a.png"), "toi_hi 0.");
}
END_TEST

START_TEST(queries_tell_what_the_other_program_tells)
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

// Films -----------------------------------------------------------------------

START_TEST(missing_ffmpeg_is_told)
{
    refuse("cannot run ffmpeg, which makes the film: No such file or directory;"
           " install it",
           "PATH=/nowhere; draw figure " FIGURE "--animate a.mp4");
    refuse("ffmpeg has failed; its own words tell why",
           "mkdir bin; printf '#!/bin/sh\\nexit 1\\n' >bin/ffmpeg; "
           "chmod +x bin/ffmpeg; PATH=$PWD/bin:$PATH; draw figure " FIGURE
           "--animate a.mp4 --frames 1; s=$?; rm -r bin; exit $s");
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
            "test -s a.%s -a -s b.%s",
            ending, ending, ending, ending);
    }
    say("command -v ffprobe >/dev/null || exit 0\n"
        "ffprobe -loglevel error -count_frames -show_entries "
        "stream=width,height,nb_read_frames -of csv=p=0 a.mp4 | "
        "grep -x 32,24,3");
    ck_assert_str_eq(say("ls -A | grep '^\\.'; true"), "");
}
END_TEST

Suite *suite(void)
{
    const TTest *const tests[] = {
        help_and_version_are_told,
        commands_are_refused,
        settings_are_refused,
        queries_are_refused,
        outputs_that_cannot_be_written_are_refused,
        missing_letters_are_refused,
        signals_leave_no_file,
        pictures_are_the_same_every_time,
        resolution_tells_the_size,
        figures_are_listed_and_tell_their_numbers,
        queries_tell_what_the_other_program_tells,
        missing_ffmpeg_is_told,
        films_are_made,
        films_show_what_moves,
    };
    Suite *s = suite_create("draw/command");
    TCase *command = tcase_create("command");
    tcase_add_checked_fixture(command, enter_folder, leave_folder);
    for (size_t i = 0; i < sizeof tests / sizeof *tests; i++)
        tcase_add_test(command, tests[i]);
    suite_add_tcase(s, command);
    return s;
}
