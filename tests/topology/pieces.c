// The pieces of a surface that are in contact.
#include "topology/pieces.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "topology/facing.h"
#include "topology/reconnector.h"

static tf_reconnector reconnector;

/// A sheet of 8 columns and two rows of squares; the vertex (i, j) has the
/// number i + 9 j.  There are two contacts.
static void begin(int a, int b, int c, int d)
{
    reconnector = (tf_reconnector){.surface = adaptive_sheet(8, 2)};
    ck_assert(
        tf_buffer_extend(&reconnector.candidate, 2, sizeof(tf_facing_edges)));
    tf_facing_edges *pair = reconnector.candidate.data;
    pair[0] = (tf_facing_edges){0, {a, b}, {a, b}};
    pair[1] = (tf_facing_edges){0, {c, d}, {c, d}};
    reconnector.candidates = 2;
    ck_assert_int_eq(tf_find_pieces(&reconnector), TF_OK);
}

static void end(void)
{
    tf_adaptive_free(reconnector.surface);
    tf_reconnector_free(&reconnector);
}

START_TEST(a_piece_reaches_to_the_neighbors)
{
    const int *piece;
    begin(0, 9, 8, 17);
    piece = reconnector.piece.data;
    ck_assert_int_eq(tf_piece_of(&reconnector, 0),
                     tf_piece_of(&reconnector, 9));
    ck_assert_int_eq(tf_piece_of(&reconnector, 0),
                     tf_piece_of(&reconnector, 1)); // beside
    ck_assert_int_eq(tf_piece_of(&reconnector, 0),
                     tf_piece_of(&reconnector, 19));
    ck_assert_int_eq(piece[2], TF_NONE); // and no further
    ck_assert_int_eq(piece[4], TF_NONE);
    ck_assert_int_ne(tf_piece_of(&reconnector, 0),
                     tf_piece_of(&reconnector, 8));
    tf_unite_pieces(&reconnector, 1, 17);
    ck_assert_int_eq(tf_piece_of(&reconnector, 19),
                     tf_piece_of(&reconnector, 8));
    end();
}
END_TEST

START_TEST(pieces_that_touch_are_united)
{
    begin(0, 9, 3, 12); // 1 is beside the one, 2 beside the other
    ck_assert_int_eq(tf_piece_of(&reconnector, 0),
                     tf_piece_of(&reconnector, 3));
    end();
    begin(0, 9, 4, 13); // 2 is beside neither
    ck_assert_int_ne(tf_piece_of(&reconnector, 0),
                     tf_piece_of(&reconnector, 4));
    end();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/pieces");
    TCase *tcase = tcase_create("pieces");
    tcase_add_test(tcase, a_piece_reaches_to_the_neighbors);
    tcase_add_test(tcase, pieces_that_touch_are_united);
    suite_add_tcase(suite, tcase);
    return suite;
}
