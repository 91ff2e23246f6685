#include "figures/numbers.h"

#include <cairo.h>
#include <glob.h>
#include <unistd.h>

enum {
    MODULES_MOST = 256,
    NAME = 64
};

/// What the figure shows, found in the files of src/ themselves.
typedef struct source {
    int modules;
    char module[MODULES_MOST][NAME];
    bool includes[MODULES_MOST][MODULES_MOST];
    bool is_public[MODULES_MOST];
} source;

/// The place of a module that is named up to a dot.
static int module_at(source *found, const char *file)
{
    char name[NAME];
    int length = (int)strcspn(file, ".");
    snprintf(name, sizeof name, "%.*s", length, file);
    int i = 0;
    while (i < found->modules && strcmp(found->module[i], name) != 0)
        i++;
    ck_assert_int_lt(i, MODULES_MOST);
    if (i == found->modules)
        strcpy(found->module[found->modules++], name);
    return i;
}

static void read_source(source *found, const char *path)
{
    char line[256], included[NAME];
    int from = module_at(found, path + strlen("src/"));
    FILE *file = fopen(path, "r");
    ck_assert_ptr_nonnull(file);
    while (fgets(line, sizeof line, file))
        if (sscanf(line, "#include \"%63[^\"]\"", included) == 1) {
            int to = module_at(found, included);
            found->includes[from][to] = from != to;
            found->is_public[from] |= strcmp(included, "base/api.h") == 0;
        }
    found->is_public[from] |= strcmp(path, "src/base/api.h") == 0;
    fclose(file);
}

static source *read_sources(void)
{
    source *found = calloc(1, sizeof *found);
    glob_t files;
    ck_assert_int_eq(glob("src/*/*.[ch]", 0, NULL, &files), 0);
    for (size_t i = 0; i < files.gl_pathc; i++)
        read_source(found, files.gl_pathv[i]);
    globfree(&files);
    return found;
}

static bool is_in_layer(const char *module, const char *layer)
{
    size_t length = strcspn(layer, "/");
    return strncmp(module, layer, length) == 0 && module[length] == '/';
}

static int count_in_layer(const source *found, const char *layer)
{
    int count = 0;
    for (int i = 0; i < found->modules; i++)
        count += is_in_layer(found->module[i], layer);
    return count;
}

/// How many includes go from the layer of one module to that of another.
static int count_between(const source *found, const char *from, const char *to)
{
    int count = 0;
    for (int i = 0; i < found->modules; i++)
        for (int j = 0; j < found->modules; j++)
            count += found->includes[i][j] &&
                     is_in_layer(found->module[i], from) &&
                     is_in_layer(found->module[j], to);
    return count;
}

/// Expect the number "from_to", which only a higher layer has of a lower one.
static void expect_arrow(const char *text, const source *found,
                         const char *from, const char *to)
{
    char key[2 * NAME], up[2 * NAME];
    int lengths[2] = {(int)strcspn(from, "/"), (int)strcspn(to, "/")};
    snprintf(key, sizeof key, "%.*s_%.*s", lengths[0], from, lengths[1], to);
    snprintf(up, sizeof up, "\n%.*s_%.*s ", lengths[1], to, lengths[0], from);
    expect_number(text, key, count_between(found, from, to));
    ck_assert_msg(!strstr(text, up), "%s goes up", key);
}

/// Expect the numbers of all includes, and of those that stay in their layer.
static void expect_includes(const char *text, const source *found)
{
    int includes = 0, within = 0;
    for (int i = 0; i < found->modules; i++)
        for (int j = 0; j < found->modules; j++) {
            const char *from = found->module[i], *to = found->module[j];
            if (!found->includes[i][j])
                continue;
            includes++;
            within += is_in_layer(to, from);
            if (!is_in_layer(to, from))
                expect_arrow(text, found, from, to);
        }
    expect_number(text, "includes", includes);
    expect_number(text, "within", within);
    expect_number(text, "down", includes - within);
    expect_number(text, "up", 0);
}

START_TEST(numbers_are_those_of_the_sources)
{
    source *found = read_sources();
    char *text = printed(&fig_layers);
    int api = 0;
    for (int i = 0; i < found->modules; i++) {
        char key[2 * NAME];
        const char *module = found->module[i];
        int length = (int)strcspn(module, "/");
        snprintf(key, sizeof key, "%.*s_modules", length, module);
        expect_number(text, key, count_in_layer(found, module));
        api += found->is_public[i];
    }
    ck_assert_int_gt(found->modules, 0);
    expect_number(text, "modules", found->modules);
    expect_number(text, "public", api);
    expect_includes(text, found);
    free(text);
    free(found);
}
END_TEST

static cairo_surface_t *draw_picture(int width, int height)
{
    fig_page_options options = {.width = fig_layers.width,
                                .height = fig_layers.height,
                                .pixels_x = width,
                                .pixels_y = height};
    char folder[] = "/tmp/tanglefree-layers-XXXXXX", path[64];
    fig_page *page;
    FILE *numbers = fopen("/dev/null", "w");
    ck_assert(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/picture.png", folder);
    ck_assert_int_eq(fig_page_new(&options, &page), FIG_OK);
    fig_layers.draw(page, numbers);
    ck_assert_int_eq(fig_page_write(page, path), FIG_OK);
    cairo_surface_t *picture = cairo_image_surface_create_from_png(path);
    fig_page_free(page);
    fclose(numbers);
    remove(path);
    rmdir(folder);
    return picture;
}

static void expect_faint(cairo_surface_t *picture, int x, int y)
{
    const unsigned char *row =
        cairo_image_surface_get_data(picture) +
        (ptrdiff_t)y * cairo_image_surface_get_stride(picture);
    ck_assert_msg(row[4 * x + 1] > 220, "(%d, %d) is on the border", x, y);
}

// What leaves the page is cut at its border.  Bands may reach there; letters,
// chips and arrows may not.
START_TEST(all_is_on_the_page)
{
    int width = 768, height = (int)(768 * fig_layers.height / fig_layers.width);
    cairo_surface_t *picture = draw_picture(width, height);
    ck_assert_int_eq(cairo_image_surface_get_width(picture), width);
    ck_assert_int_eq(cairo_image_surface_get_height(picture), height);
    for (int x = 0; x < width; x++) {
        expect_faint(picture, x, 0);
        expect_faint(picture, x, height - 1);
    }
    for (int y = 0; y < height; y++) {
        expect_faint(picture, 0, y);
        expect_faint(picture, width - 1, y);
    }
    cairo_surface_destroy(picture);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_of("figures/layers", numbers_are_those_of_the_sources);
    TCase *page = tcase_create("page");
    tcase_add_test(page, all_is_on_the_page);
    suite_add_tcase(s, page);
    return s;
}
