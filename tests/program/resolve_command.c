// The command resolve, as a user runs it.

#include "program/command.h"

#include "base/status.h"
#include "formats/mesh_reader.h"
#include "support/environments.h"
#include "support/json.h"
#include "support/program.h"
#include "support/support.h"
#include "support/terminal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// Two points fall through a triangle.
#define TRIANGLE "v -1 -1 0\nv 3 -1 0\nv -1 3 0\nf 1 2 3\n"
#define ABOVE TRIANGLE "v 0 0 1\nv 0.5 0.5 1\n"
#define BELOW TRIANGLE "v 0 0 -1\nv 0.5 0.5 -3\n"

#define AT_REST ABOVE

// A point falls through an edge in the plane.
#define FLAT_ABOVE "v -1 0\nv 1 0\nv 0 1\nl 1 2\n"
#define FLAT_BELOW "v -1 0\nv 1 0\nv 0 -1\nl 1 2\n"

// In the plane two scripted plates close upon a bar, and pass
// through each other.
#define BAR "v -1 0\nv 1 0\nl 5 6\n"
#define OPEN "v -2 -1\nv 2 -1\nv -2 1\nv 2 1\nl 1 2\nl 3 4\n" BAR
#define CLOSED "v -2 1\nv 2 1\nv -2 -1\nv 2 -1\nl 1 2\nl 3 4\n" BAR

static void enter_folder_with_files(void)
{
    enter_folder();
    make_file("above", ABOVE);
    make_file("below", BELOW);
    make_file("flat-above", FLAT_ABOVE);
    make_file("flat-below", FLAT_BELOW);
    make_file("open", OPEN);
    make_file("closed", CLOSED);
    make_file("floor", "0 1 2 # the triangle\n");
    make_file("plates", "0 1\n2 3\n");
}

// What is resolved ------------------------------------------------------------

/// Runs resolve, and expects success and that the step to `out` is clear.
static outcome resolved(const char *start, const char *end, const char *out,
                        const char *options)
{
    outcome found = run("$tf resolve %s %s -o %s %s", start, end, out, options);
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 0);
    static char report[10000];
    snprintf(report, sizeof report, "%s", found.out);
    outcome step = run("$tf detect --format summary %s %s && $tf check %s",
                       start, out, out);
    ck_assert_msg(step.status == 0, "%s", step.out);
    return (outcome){0, report, ""};
}

START_TEST(the_resolved_step_is_clear)
{
    outcome found = resolved("above", "below", "new.obj", "");
    expect_words(found.out, "status: resolved\nfirst contacts: 2\n");
    expect_words(found.out, "\nheld: 0\nmoved: 5\n");
    found = resolved("flat-above", "flat-below", "new.obj", "");
    expect_words(found.out, "status: resolved\nfirst contacts: 1\n");
}
END_TEST

START_TEST(a_clear_step_stays_as_it_is)
{
    static const char end[] =
        "v -1.1 -1e-320 -0\nv 3 -1 0.1\nv -1 3 0\nf 1 2 3\n"
        "v 0 0 0x1.fffffffffffffp+0\nv 0.3 0.7 1e300\n";
    make_file("end.obj", end);
    outcome found = resolved("above", "end.obj", "new.obj", "");
    ck_assert_int_eq(strncmp(found.out, "status: clear\n", 14), 0);
    expect_words(found.out, "\nmoved: 0\n");
    ck_assert_str_eq(file_text("new.obj"), end);
}
END_TEST

START_TEST(the_ends_are_as_computed)
{
    resolved("flat-above", "flat-below", "new.obj", "");
    ck_assert_str_eq(file_text("new.obj"), "v -1 -0.6666666666666666\n"
                                           "v 1 -0.6666666666666666\n"
                                           "v 0 0.33333333333333326\n"
                                           "l 1 2\n");
    resolved("above", "below", "new.obj", "-f floor");
    ck_assert_str_eq(file_text("new.obj"), AT_REST);
}
END_TEST

/// The positions that a file holds.
static tf_mesh_file read_mesh(const char *path)
{
    static tf_fault fault;
    tf_mesh_file mesh;
    ck_assert_msg(tf_mesh_file_read(&mesh, path, NULL, &fault), "%s",
                  fault.text);
    return mesh;
}

START_TEST(scripted_vertices_end_where_they_should)
{
    make_file("end", "v -1 -1 .1\nv 3 -1 0.2\nv -1 3 0.3\nf 1 2 3\nv 0 0 -1\n"
                     "v 0.5 0.5 -3\n");
    outcome found = resolved("above", "end", "new", "--fixed floor");
    expect_words(found.out, "\nheld: 0\nmoved: 2\n");
    tf_mesh_file wanted = read_mesh("end"), got = read_mesh("new");
    ck_assert_mem_eq(wanted.position.item, got.position.item,
                     9 * sizeof(double));
    tf_mesh_file_free(&wanted);
    tf_mesh_file_free(&got);
}
END_TEST

START_TEST(scripted_vertices_are_held_back_where_nothing_else_helps)
{
    outcome found = resolved("open", "closed", "new", "-f plates");
    ck_assert_int_eq(occurrences(found.out, "\nheld: 0\n"), 0);
    ck_assert_int_eq(occurrences(found.out, "\nfollowed: 0."), 1);
}
END_TEST

/// A coordinate of a vertex at the resolved end of the step.
static double coordinate(const char *start, const char *end,
                         const char *options, int vertex, int axis)
{
    resolved(start, end, "new", options);
    tf_mesh_file got = read_mesh("new");
    double x = got.position.item[3 * vertex + axis];
    tf_mesh_file_free(&got);
    return x;
}

START_TEST(heavy_vertices_move_less)
{
    make_file("light", "1 1 1 1 1\n");
    make_file("heavy", "1000 1000 1e3\n1\n1\n");
    double light = coordinate("above", "below", "--masses light", 0, 2);
    double heavy = coordinate("above", "below", "--masses heavy", 0, 2);
    ck_assert_msg(light < -0.5 && heavy > -0.01 && heavy < 0, "%g %g", light,
                  heavy);
}
END_TEST

START_TEST(near_elements_are_pushed_apart)
{
    make_file("near", TRIANGLE "v 0 0 1\nv 0.5 0.5 0.01\n");
    double apart = coordinate("near", "below", "-f floor", 4, 2);
    double far = coordinate("near", "below", "-f floor --separation 1", 4, 2);
    double close = coordinate("near", "below", "-f floor --separation 0", 4, 2);
    ck_assert_msg(close < 0.0101 && apart > 0.02 && far > 2 * apart, "%g %g %g",
                  close, apart, far);
}
END_TEST

START_TEST(restitution_throws_back)
{
    double stopped = coordinate("above", "below", "-f floor", 3, 2);
    double thrown =
        coordinate("above", "below", "-f floor --restitution 1", 3, 2);
    ck_assert_msg(fabs(stopped - 1) < 1e-3 && fabs(thrown - 3) < 1e-3, "%g %g",
                  stopped, thrown);
}
END_TEST

START_TEST(friction_slows_what_slides)
{
    make_file("slid", TRIANGLE "v 0.5 0 -1\nv 1 0.5 -3\n");
    double free = coordinate("above", "slid", "-f floor", 3, 0);
    double held = coordinate("above", "slid", "-f floor --friction 9", 3, 0);
    ck_assert_msg(fabs(free - 0.5) < 1e-3 && fabs(held) < 1e-3, "%g %g", free,
                  held);
}
END_TEST

START_TEST(vertices_have_their_own_friction)
{
    make_file("slid", TRIANGLE "v 0.5 0 -1\nv 1 0.5 -3\n");
    make_file("rough", "9 9 9 9 9\n");
    make_file("slippery", "9 9 9 0 0 # the edge that falls\n");
    double free =
        coordinate("above", "slid",
                   "-f floor --vertex-friction slippery --friction 9", 3, 0);
    double held =
        coordinate("above", "slid", "-f floor --vertex-friction rough", 3, 0);
    ck_assert_msg(fabs(free - 0.5) < 1e-3 && fabs(held) < 1e-3, "%g %g", free,
                  held);
}
END_TEST

START_TEST(slow_approaches_have_no_restitution)
{
    static const char all[] =
        "-f floor --restitution 1 --restitution-threshold ";
    char below[100], above[100];
    snprintf(below, sizeof below, "%s1.999", all);
    snprintf(above, sizeof above, "%s2.001", all);
    double thrown = coordinate("above", "below", below, 3, 2);
    double stopped = coordinate("above", "below", above, 3, 2);
    ck_assert_msg(fabs(stopped - 1) < 1e-3 && fabs(thrown - 3) < 1e-3, "%g %g",
                  stopped, thrown);
}
END_TEST

START_TEST(solvers_differ)
{
    static const char iterations[] = "\niterations: ";
    static const char *const options[] = {"", "--solver gauss-seidel",
                                          "--solver minres"};
    int count[3];
    for (int i = 0; i < 3; i++) {
        outcome found = resolved("above", "below", "new", options[i]);
        count[i] = atoi(strstr(found.out, iterations) + strlen(iterations));
    }
    ck_assert_int_eq(count[0], count[1]);
    ck_assert_int_ne(count[0], count[2]);
}
END_TEST

START_TEST(every_option_of_the_response_is_passed_on)
{
    static const char *const options[] = {
        "--solver gauss-seidel",
        "--solver conjugate-residuals",
        "--solver=minres",
        "--solver normal-residuals",
        "--separation 0",
        "--separation=0.5",
        "--friction 0.5",
        "--restitution 1",
        "--restitution-threshold 0.1",
        "--vertex-friction ones",
        "--substeps 3",
        "-f floor --masses ones --friction 1 --restitution .5 -t 1"};
    make_file("ones", "1 1 1 1 1");
    for (size_t i = 0; i < sizeof options / sizeof *options; i++)
        resolved("above", "below", "new", options[i]);
}
END_TEST

// Larger meshes ---------------------------------------------------------------

enum {
    SIDE = 16 // squares along a sheet
};

/// A sheet at the height `z`, wavy by `wave`, as OBJ; its first vertex has the
/// number `first`.
static void write_sheet(FILE *file, int first, double z, double wave,
                        generator *random)
{
    for (int i = 0; i <= SIDE; i++)
        for (int j = 0; j <= SIDE; j++)
            fprintf(file, "v %a %a %a\n", i + uniform(random, 0, 0.1),
                    j + uniform(random, 0, 0.1),
                    z + uniform(random, -wave, wave));
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            int corner = first + i * (SIDE + 1) + j;
            fprintf(file, "f %d %d %d\nf %d %d %d\n", corner, corner + 1,
                    corner + SIDE + 1, corner + SIDE + 2, corner + SIDE + 1,
                    corner + 1);
        }
}

/// Two sheets, the second of which falls through the first.
static void make_sheets(void)
{
    generator random = generator_new(1);
    static const char *const names[] = {"sheets", "fallen"};
    for (int i = 0; i < 2; i++) {
        FILE *file = fopen(names[i], "w");
        write_sheet(file, 1, 0, 0.1, &random);
        write_sheet(file, 1 + (SIDE + 1) * (SIDE + 1), i == 0 ? 1 : -2, 0.3,
                    &random);
        fclose(file);
    }
}

START_TEST(two_sheets_end_clear)
{
    make_sheets();
    ck_assert_int_eq(run("$tf detect sheets fallen").status, 1);
    outcome found = resolved("sheets", "fallen", "new.ply", "");
    expect_words(found.out, "status: resolved\n");
}
END_TEST

START_TEST(threads_change_nothing)
{
    make_sheets();
    outcome found =
        run("$tf resolve sheets fallen -t 1 -o one --format json | sed "
            "'s/,\"sec.*//' >one-report; for t in 2 3 8; do $tf resolve sheets "
            "fallen -t $t -o other --format json | sed 's/,\"sec.*//' | cmp - "
            "one-report && cmp one other || exit 9; done");
    expect(found, 0, "", "");
}
END_TEST

START_TEST(each_end_can_be_the_next_start)
{
    make_sheets();
    resolved("sheets", "fallen", "one", "");
    resolved("one", "sheets", "two", "--friction 0.3");
    resolved("two", "fallen", "three", "--restitution 0.5");
}
END_TEST

// Reports ---------------------------------------------------------------------

START_TEST(a_report_may_be_csv)
{
    outcome found = resolved("above", "below", "new", "--format csv");
    expect_words(found.out, "status,first_contacts,contacts,impulse_rounds,");
    expect_words(found.out, ",seconds,first_near,near,near_at_start,"
                            "exempt_zones,exempt_crossings\nresolved,2,2,");
    ck_assert_int_eq(occurrences(found.out, "\n"), 2);
}
END_TEST

START_TEST(a_report_may_be_json)
{
    outcome found = resolved("above", "below", "new", "--format json");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    expect_words(found.out, "{\"status\":\"resolved\",\"first_contacts\":2,"
                            "\"contacts\":2,\"impulse_rounds\":0,");
    expect_words(found.out, ",\"energy_before\":10,");
    const char *seconds = strstr(found.out, "\"seconds\":");
    ck_assert_ptr_nonnull(seconds);
    double took = atof(strchr(seconds, ':') + 1);
    ck_assert_msg(took > 0 && took < 60, "%g seconds", took);
    found = resolved("above", "above", "new", "--format=json");
    expect_words(found.out, "{\"status\":\"clear\",\"first_contacts\":0,");
}
END_TEST

START_TEST(progress_is_shown_on_a_terminal)
{
    terminal screen = terminal_open();
    outcome found = run("mkfifo late; { exec 3>late; sleep 1.1; cat below >&3; "
                        "} & $tf resolve above late -o new 2>%s",
                        screen.name);
    ck_assert_int_eq(found.status, 0);
    expect_progress(terminal_close(&screen), "\r1 trees");
}
END_TEST

// Files -----------------------------------------------------------------------

START_TEST(the_ending_or_the_end_chooses_the_format)
{
    static const struct {
        const char *out, *beginning;
    } files[] = {
        {"new", "v "},
        {"new.obj", "v "},
        {"new.ply", "ply\nformat binary_little_endian 1.0\n"},
        {"new.off", "OFF\n5 1 0\n"},
        {"new.stl", "binary STL of tanglefree"},
        {"new.vtp", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\""},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        ck_assert_int_eq(
            run("$tf resolve above below -o %s", files[i].out).status, 0);
        const char *text = file_text(files[i].out);
        size_t length = strlen(files[i].beginning);
        ck_assert_msg(strncmp(text, files[i].beginning, length) == 0, "%s",
                      text);
    }
    make_file("text.ply",
              "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\n"
              "property float y\nproperty float z\nelement face 1\n"
              "property list uchar int vertex_indices\nend_header\n"
              "-1 -1 0\n3 -1 0\n-1 3 0\n0 0 1\n0.5 0.5 1\n3 0 1 2\n");
    resolved("above", "text.ply", "new", "");
    expect_words(file_text("new"), "ply\nformat ascii 1.0\n");
    resolved("above", "text.ply", "new.obj", "");
    ck_assert_int_eq(strncmp(file_text("new.obj"), "v ", 2), 0);
    // All formats hold the same doubles.
    expect(run("$tf resolve new.obj new -o same >report; head -n 1 report; "
               "grep moved report; cmp same new"),
           0, "status: clear\nmoved: 0\n", "");
}
END_TEST

#define SCENE(z, floor)                                                        \
    "# frame 7\r\nmtllib m.mtl\no cloth\nv 0 0 " z "\nv 1.0 0 1\nv 0 1e0 1\n"  \
    "vt 0 0\nvn 0 0 1\nusemtl red\ns 1\nf 1/1/1 2/1/1 3/1/1\no floor\n"        \
    "v -5 -5 " floor "\nv 5 -5 " floor "\nv 5 5 " floor "\nv -5 5 " floor      \
    " 0.5 0.5 0.5\ng under\nf 4 5 6 7\n"

static const char divided[] =
    "tanglefree: %s: 1 face with more than three corners is triangulated; so "
    "are those of further files, without a message\n";

START_TEST(all_else_that_the_end_has_is_kept)
{
    make_file("start.obj", SCENE("1", "0"));
    make_file("end.obj", SCENE("-1", "0"));
    make_file("all-of-the-floor", "3 4 5 6\n");
    outcome found =
        run("$tf resolve start.obj end.obj -f all-of-the-floor -o new.obj");
    ck_assert_int_eq(found.status, 0);
    char said[200];
    snprintf(said, sizeof said, divided, "start.obj");
    ck_assert_str_eq(found.err, said);
    ck_assert_str_eq(file_text("new.obj"), SCENE("1", "0"));
    expect(run("$tf detect --format summary start.obj new.obj 2>said | head "
               "-n 2; $tf resolve new.obj start.obj -o - 2>said | cmp - "
               "start.obj"),
           0, "steps: 1\nsteps with contacts: 0\n", "");
}
END_TEST

/// Resolves to a file, and expects all that is said of it.
static void expect_said(const char *start, const char *end, const char *out,
                        const char *words)
{
    char wanted[1000], said[200] = "";
    if (strstr(start, ".obj"))
        snprintf(said, sizeof said, divided, start);
    snprintf(wanted, sizeof wanted, "%s%s%s%s%s", said,
             *words ? "tanglefree: " : "", *words ? out : "", words,
             *words ? "\n" : "");
    outcome found = run("$tf resolve %s %s -o %s", start, end, out);
    ck_assert_int_eq(found.status, 0);
    ck_assert_str_eq(found.err, wanted);
}

START_TEST(what_another_format_loses_is_said)
{
    make_file("start.obj", SCENE("1", "0"));
    make_file("end.obj", SCENE("2", "0"));
    expect_said("start.obj", "end.obj", "new.obj", "");
    expect_said(
        "start.obj", "end.obj", "new.ply",
        ": without the comments, object names, groups, materials, smoothing "
        "groups, texture coordinates and normals of end.obj");
    expect_words(file_text("new.ply"), "property double red\n");
    expect_said(
        "start.obj", "end.obj", "new.vtp",
        ": without the comments, object names, groups, materials, smoothing "
        "groups, texture coordinates, normals and polygons of "
        "end.obj");
    expect_said("above", "above", "new.ply", "");
    expect_said("above", "above", "new.stl", "");
    make_file("tenth", TRIANGLE "v 0 0 1.1\nv 0.5 0.5 1\n");
    expect_said(
        "above", "tenth", "new.stl",
        ": 1 of 15 coordinates are rounded to floats, by which "
        "elements may meet; check the file, or write a format other than "
        "STL");
}
END_TEST

START_TEST(start_and_end_are_shown_with_contacts)
{
    outcome found = run("$tf resolve above below -o seen.pvd");
    ck_assert_int_eq(found.status, 0);
    ck_assert_str_eq(found.err, "");
    expect_words(found.out, "status: resolved\nfirst contacts: 2\n");
    expect(run("grep -ahoE 'NumberOfPoints=.[0-9]+|Name=.(impulse|push)' "
               "seen/*.vtp"),
           0,
           "NumberOfPoints=\"0\nName=\"impulse\nName=\"push\n"
           "NumberOfPoints=\"2\nName=\"impulse\nName=\"push\n"
           "NumberOfPoints=\"5\nNumberOfPoints=\"5\n",
           "");
    expect(run("grep -c timestep seen.pvd; $tf resolve above below -o new.vtp "
               ">report; cmp new.vtp seen/mesh-00001.vtp"),
           0, "4\n", "");
    make_file("named", "o cloth\n" BELOW);
    expect(run("$tf resolve above named -o seen.pvd >report"), 0, "",
           "tanglefree: seen.pvd: without the object names of named\n");
    make_file("full", "before\n");
    expect(run("$tf resolve above below -o full.pvd"), 2, "",
           "tanglefree: full: cannot make this folder: File exists; choose "
           "another with -o\n");
    expect(run("$tf resolve above below -o seen.pvd >/dev/full"), 2, "",
           "tanglefree: standard output: cannot write: No space left on "
           "device; mend that, and run again\n");
}
END_TEST

/// A scene of a triangle that stays and an edge that falls on it.
static void make_scene(void)
{
    make_file("floor.obj", "# floor\n" TRIANGLE);
    make_file("rod0.ply",
              "ply\nformat ascii 1.0\ncomment rod\nelement vertex 2\n"
              "property float x\nproperty float y\nproperty float z\n"
              "property uchar red\nelement edge 1\nproperty int vertex1\n"
              "property int vertex2\nend_header\n0 0 1 255\n.5 .5 1 7\n0 1\n");
    expect(run("sed 's/0 0 1 255/0 0 -1 255/' rod0.ply >rod1.ply"), 0, "", "");
    make_file("scene.yaml",
              "meshes:\n"
              "  - {name: floor, frames: floor.obj, role: fixed}\n"
              "  - {name: rod, frames: [rod0.ply, rod1.ply]}\n");
}

START_TEST(all_else_that_frames_of_scenes_have_is_kept)
{
    make_scene();
    outcome found = run("$tf resolve scene.yaml -o new");
    ck_assert_int_eq(found.status, 0);
    ck_assert_str_eq(found.err, "");
    // The rod is back where it started.
    expect(run("ls new; cmp rod0.ply new/rod-00000.ply; cmp rod0.ply "
               "new/rod-00001.ply"),
           0, "rod-00000.ply\nrod-00001.ply\n", "");
}
END_TEST

START_TEST(scenes_are_shown)
{
    make_scene();
    outcome found = run("$tf resolve scene.yaml -o seen.pvd");
    ck_assert_int_eq(found.status, 0);
    ck_assert_str_eq(found.err, "");
    expect(run("ls seen; grep -ahoE 'NumberOf(Points|Lines|Polys)=.[0-9]+|"
               "Name=.(mesh|impulse)' seen/*1.vtp"),
           0,
           "contacts-00000.vtp\ncontacts-00001.vtp\nmesh-00000.vtp\n"
           "mesh-00001.vtp\nNumberOfPoints=\"1\nNumberOfLines=\"0\n"
           "NumberOfPolys=\"0\nName=\"impulse\nNumberOfPoints=\"5\n"
           "NumberOfLines=\"1\nNumberOfPolys=\"1\nName=\"mesh\n",
           "");
}
END_TEST

START_TEST(what_cannot_be_written_is_refused)
{
    make_file("new.glb", "before\n");
    expect(run("$tf resolve above below -o new.glb"), 2, "",
           "tanglefree: new.glb: .glb is not written; end the name in .obj, "
           ".ply, .stl, .off or .vtp\n");
    ck_assert_str_eq(file_text("new.glb"), "before\n");
    expect(run("$tf resolve flat-above flat-below -o new.off"), 2, "",
           "tanglefree: new.off: OFF holds faces, and this mesh has only "
           "edges; end the name in .obj, .ply or .vtp\n");
    expect(run("ls new.off 2>/dev/null"), 2, "", "");
}
END_TEST

START_TEST(curves_are_written_as_ply)
{
    make_file("end.ply",
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
              "property double y\nelement edge 1\nproperty int vertex1\n"
              "property int vertex2\nend_header\n-1 0\n1 0\n0 -1\n0 1\n");
    resolved("flat-above", "end.ply", "new", "");
    expect_words(file_text("new"), "format ascii 1.0\nelement vertex 3\n");
    expect_words(file_text("new"), "\nelement edge 1\n");
    resolved("flat-above", "flat-below", "same.ply", "");
    // The same curve in text, in binary and as OBJ.
    resolved("flat-above", "flat-below", "same", "");
    expect(run("for f in new same.ply; do $tf resolve $f same -o again >report "
               "|| exit; head -n 1 report; cmp again same; done"),
           0, "status: clear\nstatus: clear\n", "");
}
END_TEST

START_TEST(standard_input_and_output_are_used)
{
    resolved("above", "below", "new", "");
    char right[10000];
    snprintf(right, sizeof right, "%s", file_text("new"));
    outcome found = run("$tf resolve above below -o -");
    ck_assert_str_eq(found.out, right);
    expect_words(found.err, "status: resolved\nfirst contacts: 2\n");
    found = run("cat below | $tf resolve above - -o - 2>report");
    expect(found, 0, right, "");
    found = run("$tf resolve - below --output=- <above 2>report");
    expect(found, 0, right, "");
    found = run("$tf resolve above below -o - --format json 2>&1 >mesh");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    found = run("echo 0 1 2 | $tf resolve above below -f - -o new");
    ck_assert_int_eq(found.status, 0);
    expect_words(file_text("new"), "v -1 -1 0\nv 3 -1 0\nv -1 3 0\n");
}
END_TEST

START_TEST(the_output_may_replace_the_input)
{
    resolved("above", "below", "new", "");
    expect(run("cp below both; $tf resolve above both -o both >report && cmp "
               "new both"),
           0, "", "");
    expect(run("cp above both; $tf resolve both below -o both >report && cmp "
               "new both; ls -A | grep -c tanglefree"),
           1, "0\n", "");
}
END_TEST

// Bad input -------------------------------------------------------------------

/// Expects an error, and that the file `new`, if there is one, stays as it is.
static void expect_error(const char *arguments, const char *message)
{
    make_file("new", "as before");
    outcome found = run("$tf resolve -o new %s", arguments);
    expect(found, 2, "", message);
    ck_assert_str_eq(file_text("new"), "as before");
    found = run("rm new; $tf resolve -o new %s", arguments);
    expect(found, 2, "", message);
    expect(run("ls -A | grep 'new\\|tanglefree'"), 1, "", "");
}

START_TEST(starts_that_are_not_clear_are_refused)
{
    static const char rest[] = " (numbered from 0) before the step begins; "
                               "move them apart, see 'tanglefree check' for "
                               "all such pairs\n";
    static const struct {
        const char *start, *words;
    } starts[] = {
        {TRIANGLE "v 0.5 0.5 0\nv 9 9 9\n", "vertex 3 lies on triangle 0 1 2"},
        {TRIANGLE "v 0 0 -1\nv 0.5 0.5 1\nl 4 5\n",
         "edge 3 4 passes through triangle 0 1 2"},
        {TRIANGLE "v 1 -1 -1\nv 1 -1 1\nl 4 5\n", "edge 0 1 meets edge 3 4"},
        {"v 0 0\nv 2 2\nv 0 2\nv 2 0\nl 1 2\nl 3 4\n",
         "edge 0 1 meets edge 2 3"},
        {"v 0 0\nv 2 2\nv 1 1\nl 1 2\n", "vertex 2 lies on edge 0 1"},
    };
    for (size_t i = 0; i < sizeof starts / sizeof *starts; i++) {
        char message[1000];
        make_file("start", starts[i].start);
        make_file("end", starts[i].start);
        snprintf(message, sizeof message, "tanglefree: start: %s%s",
                 starts[i].words, rest);
        expect_error("start end", message);
    }
}
END_TEST

// Starts that cross -----------------------------------------------------------

// Two triangles that cross, and a point that is above the first one, or below;
// the second triangle goes on through the first, or stays.
#define CROSSED(lift)                                                          \
    "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n"                                     \
    "v 1 1 " lift "\nv 1 1 1\nv 9 9 1\nf 4 5 6\n"
#define OVER CROSSED("-1") "v 2 0.5 1\n"
#define UNDER CROSSED("-2") "v 2 0.5 -1\n"

static const char left_out[] = "file,kind,a,b,c,d,e,f\n"
                               "over.obj,edge-triangle,1,2,3,4,5,\n"
                               "over.obj,edge-triangle,3,4,0,1,2,\n";

static void make_crossed(void)
{
    make_file("over.obj", OVER);
    make_file("under.obj", UNDER);
}

START_TEST(what_crosses_may_be_left_out)
{
    char list[300];
    make_crossed();
    outcome found =
        run("$tf resolve over.obj under.obj -o new.obj --exempt-crossings");
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 0);
    expect_words(found.out, "status: resolved\nfirst contacts: 1\n");
    snprintf(list, sizeof list, "\nexempt zones: 1\nexempt crossings: 2\n\n%s",
             left_out);
    expect_words(found.out, list);
    // The triangles still cross, and the point is above the first one, or the
    // step would not be resolved.
    expect_words(run("$tf check new.obj").out,
                 "new.obj,edge-triangle,3,4,0,1,2,\n");
    found = run("$tf detect --format summary over.obj new.obj");
    expect_words(found.out, "\ncontacts: 0\n");
}
END_TEST

START_TEST(what_is_left_out_is_listed_in_the_format_of_the_report)
{
    make_crossed();
    outcome found = run("$tf resolve over.obj under.obj -o new.obj "
                        "--exempt-crossings --format json | tail -n +2");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    expect_words(found.out, "{\"file\":\"over.obj\",\"kind\":\"edge-triangle\","
                            "\"a\":1,\"b\":2,\"c\":3,\"d\":4,\"e\":5}");
    found = run("$tf resolve over.obj under.obj -o new.obj "
                "--exempt-crossings --format csv | tail -n +3");
    ck_assert_str_eq(found.out + 1, left_out);
    // Where the mesh is not.
    found = run("$tf resolve over.obj under.obj -o - --exempt-crossings "
                "2>report >mesh; tail -n 3 report");
    ck_assert_str_eq(found.out, left_out);
    expect(run("$tf resolve over.obj under.obj -o new.obj "
               "--exempt-crossings -t 3 >same; cmp mesh new.obj"),
           0, "", "");
    found = run("$tf resolve over.obj under.obj -o shown.pvd "
                "--exempt-crossings | tail -n 3");
    ck_assert_str_eq(found.out, left_out);
}
END_TEST

START_TEST(a_clear_start_has_nothing_to_leave_out)
{
    make_file("flat", "v 0 0\nv 2 2\nv 0 2\nv 2 0\nl 1 2\nl 3 4\n");
    outcome found = resolved("above", "below", "new", "--exempt-crossings");
    ck_assert_str_eq(strstr(found.out, "exempt zones"),
                     "exempt zones: 0\nexempt crossings: 0\n");
    expect(run("$tf resolve above below -o usual >report; cmp new usual"), 0,
           "", "");
    expect_words(run("$tf resolve flat flat -o new --exempt-crossings").out,
                 "exempt zones: 1\nexempt crossings: 1\n\n");
}
END_TEST

START_TEST(what_crosses_outside_of_zones_is_refused)
{
    make_file("start", TRIANGLE "v 0 0 -1\nv 0.5 0.5 1\nl 4 5\n");
    expect(run("$tf resolve start start -o new --exempt-crossings"), 2, "",
           "tanglefree: start: edge 3 4 passes through triangle 0 1 2 "
           "(numbered from 0) before the step begins; move them apart, see "
           "'tanglefree check' for all such pairs\n");
    make_file("scene.yaml", "meshes: []\n");
    expect_usage("resolve scene.yaml -o new --exempt-crossings",
                 "tanglefree resolve: --exempt-crossings is for two meshes\n");
}
END_TEST

START_TEST(files_that_do_not_fit_are_refused)
{
    make_file("nan", TRIANGLE "v nan 0 0\nv 0 0 0\n");
    make_file("other", "v -1 -1 0\nv 3 -1 0\nv -1 3 0\nv 0 0 1\nv 1 1 1\n"
                       "f 2 3 1\n");
    expect_error("above nan", "tanglefree: nan:5: 'nan' is not a finite "
                              "number; write a decimal or a hexadecimal "
                              "float\n");
    expect_error("absent below",
                 "tanglefree: absent: cannot open: No such file or directory; "
                 "check the name\n");
    expect_error("above .", "tanglefree: .: cannot read: Is a directory; check "
                            "that this is a file\n");
    expect_error("above flat-below",
                 "tanglefree: flat-below: 3 vertices, but above has 5; all "
                 "files must have the same elements\n");
    expect_error("above other",
                 "tanglefree: other:6: this triangle is not as in above; all "
                 "files must have the same elements in the same order\n");
}
END_TEST

START_TEST(lists_that_do_not_fit_are_refused)
{
    make_file("list", "0\n1 5\n");
    make_file("masses", "1 1\n1 0 1\n");
    make_file("few", "1 1 1\n");
    expect_error("above below -f list",
                 "tanglefree: list:2: there is no vertex 5; they are numbered "
                 "from 0 to 4\n");
    expect_error("above below -f absent",
                 "tanglefree: absent: cannot open: No such file or directory; "
                 "check the name\n");
    expect_error(
        "above below --masses masses",
        "tanglefree: masses:2: '0' is not a mass; write a number above 0 "
        "such as 0.5\n");
    expect_error("above below --masses few",
                 "tanglefree: few: the number of masses is 3, but there are 5 "
                 "vertices; write one for each, in their order\n");
    make_file("rubber", "1 1\n1 1 -1\n");
    expect_error("above below --vertex-friction rubber",
                 "tanglefree: rubber:2: '-1' is not a coefficient of friction; "
                 "write a number from 0 on such as 0.5\n");
    expect_error("above below --masses few -f few",
                 "tanglefree: few: the number of masses is 3, but there are 5 "
                 "vertices; write one for each, in their order\n");
}
END_TEST

// Output that cannot be written -----------------------------------------------

START_TEST(a_full_disk_is_reported)
{
    expect(run("$tf resolve above below -o /dev/fd/3 3>/dev/full"), 2, "",
           "tanglefree: /dev/fd/3: cannot write: No space left on device; mend "
           "that, and run again\n");
    expect(run("$tf resolve above below -o - >/dev/full"), 2, "",
           "tanglefree: standard output: cannot write: No space left on "
           "device; mend that, and run again\n");
    expect_error("above below >/dev/full",
                 "tanglefree: standard output: cannot write: No space left on "
                 "device; mend that, and run again\n");
    expect(run("$tf resolve above below -o - >mesh 2>/dev/full"), 2, "", "");
    expect_error("above below >&-",
                 "tanglefree: standard output: cannot write: Bad file "
                 "descriptor; mend that, and run again\n");
}
END_TEST

// The limit leaves room for what a program writes that counts its lines.
START_TEST(a_file_that_gets_too_large_is_reported)
{
    make_sheets();
    run("for file in sheets fallen; do yes v 9 9 9 | head -n 6000 >>$file; "
        "done");
    make_file("new", "as before");
    expect(run("ulimit -f 64; $tf resolve sheets fallen -o new"), 2, "",
           "tanglefree: new: cannot write: File too large; mend that, and run "
           "again\n");
    ck_assert_str_eq(file_text("new"), "as before");
    expect(run("ls -A | grep tanglefree"), 1, "", "");
}
END_TEST

START_TEST(unwritable_places_are_reported)
{
    expect(run("$tf resolve above below -o absent/new"), 2, "",
           "tanglefree: absent/new: there is no folder 'absent'; make it, or "
           "choose another\n");
    expect(run("$tf resolve above below -o ."), 2, "",
           "tanglefree: .: cannot write: Is a directory; mend that, and run "
           "again\n");
    expect(run("$tf resolve above below -o - >&-"), 2, "",
           "tanglefree: standard output: cannot write: Bad file descriptor; "
           "mend that, and run again\n");
}
END_TEST

// Usage -----------------------------------------------------------------------

START_TEST(help_describes_the_command)
{
    outcome found = run("$tf resolve --help");
    ck_assert_int_eq(found.status, 0);
    ck_assert_str_eq(found.err, "");
    static const char *const words[] = {
        "Usage: tanglefree resolve [OPTION...] START END",
        "-o, --output=OUT",
        "-f, --fixed=FILE",
        "--masses=FILE",
        "--solver=NAME",
        "--separation=X",
        "--exempt-crossings",
        "--friction=X",
        "--vertex-friction=FILE",
        "--restitution=X",
        "--restitution-threshold=X",
        "--substeps=N",
        "--format=FORMAT",
        "-t, --threads=NUMBER",
        "csv, json or summary;",
        "Exit status"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        expect_words(found.out, words[i]);
    expect_words(run("$tf --help").out, "\n  resolve ");
}
END_TEST

START_TEST(old_spellings_are_refused)
{
    static const char *const words[] = {"csv", "json", "summary"};
    for (int i = 0; i < 3; i++) {
        char arguments[100];
        snprintf(arguments, sizeof arguments,
                 "resolve above below -o new --output %s", words[i]);
        expect_usage(arguments, "tanglefree resolve: --output ");
    }
    expect_usage("resolve above below --output=json",
                 "tanglefree resolve: --output json is an old spelling; write "
                 "--format json, or ./json for a file of that name\n");
    expect_usage("resolve above below --write new",
                 "tanglefree resolve: --write is an old spelling; write "
                 "--output\n");
    expect_usage("resolve above below --write=new",
                 "tanglefree resolve: --write is an old spelling; write "
                 "--output\n");
    expect_usage("resolve above below -o new -m ones",
                 "tanglefree resolve: -m is an old spelling; write "
                 "--masses\n");
    expect_usage("resolve above below -o new -s minres",
                 "tanglefree resolve: -s is an old spelling; write "
                 "--solver\n");
    ck_assert_int_eq(occurrences(run("$tf resolve --help").out, "--write"), 0);
    ck_assert_int_eq(run("$tf resolve above below -o ./json").status, 0);
    expect_words(file_text("json"), "v ");
}
END_TEST

START_TEST(wrong_arguments_are_refused)
{
    static const char two[] = "tanglefree resolve: two files are required, "
                              "START and END, or a scene, whose name "
                              "ends in .yaml, .yml or .json\n";
    expect_usage("resolve", two);
    expect_usage("resolve -o new above", two);
    expect_usage("resolve -o new above below below", two);
    expect_usage("resolve above below",
                 "tanglefree resolve: --output OUT is required: where to write "
                 "the end of the step, or the folder for the frames of a "
                 "scene\n");
    expect_usage("resolve above below -o new --solver cg",
                 "tanglefree resolve: --solver must be gauss-seidel, "
                 "conjugate-residuals, minres or normal-residuals, got 'cg'\n");
    expect_usage("resolve above below -o new --format xml",
                 "tanglefree resolve: --format must be csv, json or summary, "
                 "got 'xml'\n");
    expect_usage(
        "resolve above below -o new --restitution 1.1",
        "tanglefree resolve: --restitution must be a number from 0 to 1, got "
        "'1.1'\n");
    expect_usage(
        "resolve above below -o new --friction=-1",
        "tanglefree resolve: --friction must be a number from 0 on, got "
        "'-1'\n");
    expect_usage("resolve above below -o new --restitution-threshold=-1",
                 "tanglefree resolve: --restitution-threshold must be a number "
                 "from 0 on, got '-1'\n");
    expect_usage(
        "resolve above below -o new --separation inf",
        "tanglefree resolve: --separation must be a number from 0 on, got "
        "'inf'\n");
    expect_usage("resolve above below -o new -t 0",
                 "tanglefree resolve: --threads must be a whole number from 1 "
                 "to 256, got '0'\n");
    expect_usage("resolve above below -o new -a exact",
                 "tanglefree resolve: invalid option -- 'a'");
}
END_TEST

// A broken floating-point environment -----------------------------------------

static int run_resolve(int argc, char *argv[])
{
    return tf_command_run(&tf_resolve_command, argc, argv);
}

START_TEST(a_broken_environment_is_reported)
{
    static const char *const arguments[] = {"tanglefree", "above", "below",
                                            "-o",         "new",   NULL};
    char message[1000];
    snprintf(message, sizeof message, "tanglefree: below: %s\n",
             tf_status_message(TF_BAD_ENVIRONMENT));
    expect(run_broken(_i, run_resolve, arguments), 2, "", message);
    ck_assert_int_ne(access("new", F_OK), 0);
}
END_TEST

static TCase *add_case(Suite *suite, const char *name)
{
    TCase *made = tcase_create(name);
    tcase_add_checked_fixture(made, enter_folder_with_files, leave_folder);
    suite_add_tcase(suite, made);
    return made;
}

Suite *suite(void)
{
    Suite *suite = suite_create("program/resolve_command");
    TCase *small = add_case(suite, "what is resolved");
    tcase_add_test(small, the_resolved_step_is_clear);
    tcase_add_test(small, a_clear_step_stays_as_it_is);
    tcase_add_test(small, the_ends_are_as_computed);
    tcase_add_test(small, scripted_vertices_end_where_they_should);
    tcase_add_test(small,
                   scripted_vertices_are_held_back_where_nothing_else_helps);
    tcase_add_test(small, heavy_vertices_move_less);
    tcase_add_test(small, near_elements_are_pushed_apart);
    tcase_add_test(small, restitution_throws_back);
    tcase_add_test(small, slow_approaches_have_no_restitution);
    tcase_add_test(small, friction_slows_what_slides);
    tcase_add_test(small, vertices_have_their_own_friction);
    tcase_add_test(small, solvers_differ);
    tcase_add_test(small, every_option_of_the_response_is_passed_on);

    TCase *large = add_case(suite, "larger meshes");
    tcase_add_test(large, two_sheets_end_clear);
    tcase_add_test(large, threads_change_nothing);
    tcase_add_test(large, each_end_can_be_the_next_start);

    TCase *reports = add_case(suite, "reports");
    tcase_add_test(reports, a_report_may_be_csv);
    tcase_add_test(reports, a_report_may_be_json);
    tcase_add_test(reports, progress_is_shown_on_a_terminal);

    TCase *files = add_case(suite, "files");
    tcase_add_test(files, the_ending_or_the_end_chooses_the_format);
    tcase_add_test(files, all_else_that_the_end_has_is_kept);
    tcase_add_test(files, what_another_format_loses_is_said);
    tcase_add_test(files, start_and_end_are_shown_with_contacts);
    tcase_add_test(files, all_else_that_frames_of_scenes_have_is_kept);
    tcase_add_test(files, scenes_are_shown);
    tcase_add_test(files, what_cannot_be_written_is_refused);
    tcase_add_test(files, curves_are_written_as_ply);
    tcase_add_test(files, standard_input_and_output_are_used);
    tcase_add_test(files, the_output_may_replace_the_input);

    TCase *bad = add_case(suite, "bad input");
    tcase_add_test(bad, starts_that_are_not_clear_are_refused);
    tcase_add_test(bad, what_crosses_may_be_left_out);
    tcase_add_test(bad, what_is_left_out_is_listed_in_the_format_of_the_report);
    tcase_add_test(bad, a_clear_start_has_nothing_to_leave_out);
    tcase_add_test(bad, what_crosses_outside_of_zones_is_refused);
    tcase_add_test(bad, files_that_do_not_fit_are_refused);
    tcase_add_test(bad, lists_that_do_not_fit_are_refused);

    TCase *unwritten = add_case(suite, "output that cannot be written");
    tcase_add_test(unwritten, a_full_disk_is_reported);
    tcase_add_test(unwritten, a_file_that_gets_too_large_is_reported);
    tcase_add_test(unwritten, unwritable_places_are_reported);

    TCase *usage = add_case(suite, "usage");
    tcase_add_test(usage, help_describes_the_command);
    tcase_add_test(usage, old_spellings_are_refused);
    tcase_add_test(usage, wrong_arguments_are_refused);

    TCase *environment = add_case(suite, "a broken environment");
    tcase_add_loop_test(environment, a_broken_environment_is_reported, 0,
                        environments());
    return suite;
}
