// The pieces of a surface that are in contact.
#include "topology/reconnector.h"

#include "support/adaptive_of.h"
#include "support/support.h"

static tf_reconnect_report report;
static tf_reconnector of;

/// A sheet of 8 columns and two rows of squares; the vertex (i, j) has the
/// number i + 9 j.  There are two contacts.
static void begin(int a, int b, int c, int d)
{
    of = (tf_reconnector){.of = adaptive_sheet(8, 2), .report = &report};
    ck_assert(tf_buffer_extend(&of.row, 2, sizeof(tf_facing)));
    tf_facing *row = of.row.data;
    row[0] = (tf_facing){0, {a, b}, {a, b}};
    row[1] = (tf_facing){0, {c, d}, {c, d}};
    of.rows = 2;
    ck_assert(tf_find_pieces(&of));
}

static void end(void)
{
    tf_adaptive_free(of.of);
    tf_reconnector_free(&of);
}

START_TEST(a_piece_reaches_to_the_neighbors)
{
    const int *piece;
    begin(0, 9, 8, 17);
    piece = of.piece.data;
    ck_assert_int_eq(tf_piece_of(&of, 0), tf_piece_of(&of, 9));
    ck_assert_int_eq(tf_piece_of(&of, 0), tf_piece_of(&of, 1)); // beside
    ck_assert_int_eq(tf_piece_of(&of, 0), tf_piece_of(&of, 19));
    ck_assert_int_eq(piece[2], TF_NONE); // and no further
    ck_assert_int_eq(piece[4], TF_NONE);
    ck_assert_int_ne(tf_piece_of(&of, 0), tf_piece_of(&of, 8));
    tf_unite_pieces(&of, 1, 17);
    ck_assert_int_eq(tf_piece_of(&of, 19), tf_piece_of(&of, 8));
    end();
}
END_TEST

START_TEST(pieces_that_touch_are_one)
{
    begin(0, 9, 3, 12); // 1 is beside the one, 2 beside the other
    ck_assert_int_eq(tf_piece_of(&of, 0), tf_piece_of(&of, 3));
    end();
    begin(0, 9, 4, 13); // 2 is beside neither
    ck_assert_int_ne(tf_piece_of(&of, 0), tf_piece_of(&of, 4));
    end();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/pieces");
    TCase *tcase = tcase_create("pieces");
    tcase_add_test(tcase, a_piece_reaches_to_the_neighbors);
    tcase_add_test(tcase, pieces_that_touch_are_one);
    suite_add_tcase(suite, tcase);
    return suite;
}
