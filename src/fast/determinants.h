//: Hold one query
#pragma once

#include "base/always_inline.h"
#include "geometry/vector.h"

/// The four vertices of a query at the start and at the end: those of the first
/// element, then those of the second, each element's in the order of indices.
typedef struct tf_lane {
    tf_vector start[4], end[4];
} tf_lane;

//: Choose without a branch
TF_ALWAYS_INLINE double tf_least(double a, double b)
{
    return a < b ? a : b;
}

TF_ALWAYS_INLINE double tf_most(double a, double b)
{
    return a > b ? a : b;
}

//: Hold the range of some numbers
typedef struct tf_lane_range {
    double low, high;
} tf_lane_range;

TF_ALWAYS_INLINE tf_lane_range tf_lane_range_of(double a, double b)
{
    return (tf_lane_range){tf_least(a, b), tf_most(a, b)};
}

TF_ALWAYS_INLINE tf_lane_range tf_lane_union(tf_lane_range a, tf_lane_range b)
{
    return (tf_lane_range){tf_least(a.low, b.low), tf_most(a.high, b.high)};
}

//: Find the range of four or five numbers
TF_ALWAYS_INLINE tf_lane_range tf_lane_range_of_4(double a, double b, double c,
                                                  double d)
{
    return tf_lane_union(tf_lane_range_of(a, b), tf_lane_range_of(c, d));
}

TF_ALWAYS_INLINE tf_lane_range tf_lane_range_of_5(double a, double b, double c,
                                                  double d, double e)
{
    tf_lane_range four = tf_lane_range_of_4(a, b, c, d);
    return (tf_lane_range){tf_least(four.low, e), tf_most(four.high, e)};
}

//: Join what pairs of simplices show
/// The greatest of the least numbers, and the least of the greatest.
TF_ALWAYS_INLINE tf_lane_range tf_lane_common(tf_lane_range a, tf_lane_range b)
{
    return (tf_lane_range){tf_most(a.low, b.low), tf_least(a.high, b.high)};
}

/// If this is positive, all numbers of some pair have one sign, and are at
/// least that far from zero.
TF_ALWAYS_INLINE double tf_lane_agreement(tf_lane_range range)
{
    return tf_most(range.low, -range.high);
}

/// If this is positive, two numbers of each pair have opposite signs, and are
/// at least that far from zero.
TF_ALWAYS_INLINE double tf_lane_conflict(tf_lane_range range)
{
    return tf_least(range.high, -range.low);
}

//: Measure an axis
/// What one axis shows: how far it separates the elements, if that is positive,
/// and the largest difference between coordinates of the two at one time.
typedef struct tf_lane_axis {
    double gap, reach;
} tf_lane_axis;

/// Of the differences of the triangle's vertices to the point.
TF_ALWAYS_INLINE tf_lane_axis tf_lane_point_axis(int k, tf_vector A,
                                                 tf_vector B, tf_vector C,
                                                 tf_vector a, tf_vector b,
                                                 tf_vector c)
{
    tf_lane_range all =
        tf_lane_union(tf_lane_range_of_4(A.x[k], B.x[k], C.x[k], a.x[k]),
                      tf_lane_range_of(b.x[k], c.x[k]));
    return (tf_lane_axis){.gap = tf_most(all.low, -all.high),
                          .reach = tf_most(all.high, -all.low)};
}

//: Measure the gaps between two ranges
/// How far two ranges are apart, each way, where that is positive: the first
/// beyond the second, and the second beyond the first.
typedef struct tf_lane_gaps {
    double beyond, before;
} tf_lane_gaps;

TF_ALWAYS_INLINE tf_lane_gaps tf_lane_gaps_of(tf_lane_range s, tf_lane_range r)
{
    return (tf_lane_gaps){s.low - r.high, r.low - s.high};
}

//: Measure an axis of two edges
/// Of the vertices of the edges AB and CD, and later ab and cd.
TF_ALWAYS_INLINE tf_lane_axis tf_lane_edges_axis(int k, const tf_lane *lane)
{
    const tf_vector *s = lane->start, *e = lane->end;
    tf_lane_gaps start =
        tf_lane_gaps_of(tf_lane_range_of(s[0].x[k], s[1].x[k]),
                        tf_lane_range_of(s[2].x[k], s[3].x[k]));
    tf_lane_gaps end = tf_lane_gaps_of(tf_lane_range_of(e[0].x[k], e[1].x[k]),
                                       tf_lane_range_of(e[2].x[k], e[3].x[k]));
    double beyond = tf_least(start.beyond, end.beyond);
    double before = tf_least(start.before, end.before);
    return (tf_lane_axis){.gap = tf_most(beyond, before),
                          .reach = -tf_least(beyond, before)};
}

//: Hold what a query shows
typedef struct tf_lane_evidence {
    double gap;       ///< > 0: an axis separates the elements
    double agreement; ///< > error: the signs of some pair of simplices agree
    double conflict;  ///< > error: those of each pair are in conflict
    double reach;     ///< the largest difference on each axis, added up
    double volume;    ///< the product of the three, a little more if tiny
    double sum;       ///< finite only if all coordinates are
} tf_lane_evidence;

/// Added to the reach of each axis, so that the volume does not underflow.  It
/// vanishes in the rounding unless the reach is tiny.
#define TF_LEAST_REACH 0x1p-300

TF_ALWAYS_INLINE tf_lane_evidence tf_lane_evidence_of(tf_lane_axis x,
                                                      tf_lane_axis y,
                                                      tf_lane_axis z)
{
    return (tf_lane_evidence){.gap = tf_most(x.gap, tf_most(y.gap, z.gap)),
                              .reach = x.reach + y.reach + z.reach,
                              .volume = (x.reach + TF_LEAST_REACH) *
                                        (y.reach + TF_LEAST_REACH) *
                                        (z.reach + TF_LEAST_REACH)};
}

//: Hold the weights of events
/// The weights of the events of the three tetrahedra that a triangle sweeps, in
/// the order of their names.  The path of the point crosses a tetrahedron if its
/// four weights have one sign, and then they are in proportion to the barycentric
/// coordinates of the place where it does.
typedef struct tf_lane_tetrahedra {
    double ABCc[4], ABbc[4], Aabc[4];
} tf_lane_tetrahedra;

/// The same for the four pairs of triangles that two edges sweep: the weights of
/// the first triangle's events, then of the second's.  The weights of the two
/// have the same sum, and so have those of their events at the end.
typedef struct tf_lane_triangles {
    double ABb_CDd[6], ABb_Ccd[6], Aab_CDd[6], Aab_Ccd[6];
} tf_lane_triangles;

//: Find the range of weights
/// The range of the weights of a tetrahedron.
TF_ALWAYS_INLINE tf_lane_range tf_lane_range_of_weights(const double weight[4])
{
    return tf_lane_range_of_4(weight[0], weight[1], weight[2], weight[3]);
}

//: Weigh a point and a triangle
TF_ALWAYS_INLINE tf_lane_evidence
tf_lane_point_triangle(const tf_lane *lane, tf_lane_tetrahedra *weights)
{
    //: Let the point stand still at the origin
    const tf_vector *s = lane->start, *e = lane->end;
    tf_vector A = tf_vector_difference(s[1], s[0]);
    tf_vector B = tf_vector_difference(s[2], s[0]);
    tf_vector C = tf_vector_difference(s[3], s[0]);
    tf_vector a = tf_vector_difference(e[1], e[0]);
    tf_vector b = tf_vector_difference(e[2], e[0]);
    tf_vector c = tf_vector_difference(e[3], e[0]);
    tf_lane_evidence found =
        tf_lane_evidence_of(tf_lane_point_axis(0, A, B, C, a, b, c),
                            tf_lane_point_axis(1, A, B, C, a, b, c),
                            tf_lane_point_axis(2, A, B, C, a, b, c));

    //: Compute ten determinants from four cross products
    tf_vector AB = tf_vector_cross(A, B), bc = tf_vector_cross(b, c);
    tf_vector Aa = tf_vector_cross(A, a), Cc = tf_vector_cross(C, c);
    double ABC = tf_vector_dot(AB, C), ABb = tf_vector_dot(AB, b);
    double ABc = tf_vector_dot(AB, c), Aab = tf_vector_dot(Aa, b);
    double Aac = tf_vector_dot(Aa, c), BCc = tf_vector_dot(B, Cc);
    double ACc = tf_vector_dot(A, Cc), Abc = tf_vector_dot(A, bc);
    double Bbc = tf_vector_dot(B, bc), abc = tf_vector_dot(a, bc);

    //: Weigh the events of three tetrahedra
    *weights = (tf_lane_tetrahedra){.ABCc = {BCc, -ACc, ABc, -ABC},
                                    .ABbc = {Bbc, -Abc, ABc, -ABb},
                                    .Aabc = {abc, -Abc, Aac, -Aab}};

    //: Compare the signs within each of three tetrahedra
    tf_lane_range ABCc = tf_lane_range_of_weights(weights->ABCc);
    tf_lane_range ABbc = tf_lane_range_of_weights(weights->ABbc);
    tf_lane_range Aabc = tf_lane_range_of_weights(weights->Aabc);
    tf_lane_range all = tf_lane_common(ABCc, tf_lane_common(ABbc, Aabc));
    found.agreement = tf_lane_agreement(all);
    found.conflict = tf_lane_conflict(all);
    found.sum = ABC + abc;
    return found;
}

//: Weigh two edges
TF_ALWAYS_INLINE tf_lane_evidence tf_lane_edge_edge(const tf_lane *lane,
                                                    tf_lane_triangles *weights)
{
    //: Take the differences of two moving edges
    tf_vector A = lane->start[0], a = lane->end[0];
    tf_vector B = lane->start[1], b = lane->end[1];
    tf_vector C = lane->start[2], c = lane->end[2];
    tf_vector D = lane->start[3], d = lane->end[3];
    tf_vector AB = tf_vector_difference(B, A), ba = tf_vector_difference(a, b);
    tf_vector CA = tf_vector_difference(A, C), bc = tf_vector_difference(c, b);
    tf_vector AD = tf_vector_difference(D, A), bd = tf_vector_difference(d, b);
    tf_lane_evidence found = tf_lane_evidence_of(tf_lane_edges_axis(0, lane),
                                                 tf_lane_edges_axis(1, lane),
                                                 tf_lane_edges_axis(2, lane));

    //: Compute twelve determinants from four cross products
    tf_vector DC = tf_vector_cross(CA, AD), cC = tf_vector_cross(CA, bc);
    tf_vector ad = tf_vector_cross(ba, bd), Bd = tf_vector_cross(AB, bd);
    double DCB = tf_vector_dot(DC, AB), cCB = tf_vector_dot(cC, AB);
    double DCa = tf_vector_dot(DC, ba), cCa = tf_vector_dot(cC, ba);
    double DCd = tf_vector_dot(DC, bd), cCd = tf_vector_dot(cC, bd);
    double adC = tf_vector_dot(ad, CA), BdC = tf_vector_dot(Bd, CA);
    double adD = tf_vector_dot(ad, AD), BdD = tf_vector_dot(Bd, AD);
    double adc = tf_vector_dot(ad, bc), Bdc = tf_vector_dot(Bd, bc);

    //: Weigh the events of four pairs of triangles
    *weights = (tf_lane_triangles){
        .ABb_CDd = {(BdC - DCd) + BdD, DCd, DCB, BdD, BdC, DCB},
        .ABb_Ccd = {Bdc - cCd, cCd, BdC + cCB, Bdc, BdC, cCB},
        .Aab_CDd = {adD + adC, DCd, DCa - DCd, adD, adC, DCa},
        .Aab_Ccd = {adc, cCd, (adC - cCd) + cCa, adc, adC, cCa}};

    //: Compare the signs within each of four pairs
    // A weight that is the same as another, or the sum of two, adds nothing.
    const double *w = weights->ABb_CDd;
    tf_lane_range ABb_CDd = tf_lane_range_of_5(w[0], w[1], w[3], w[4], w[5]);
    w = weights->ABb_Ccd;
    tf_lane_range ABb_Ccd = tf_lane_range_of_4(w[0], w[1], w[4], w[5]);
    w = weights->Aab_CDd;
    tf_lane_range Aab_CDd = tf_lane_range_of_4(w[3], w[4], w[1], w[2]);
    w = weights->Aab_Ccd;
    tf_lane_range Aab_Ccd = tf_lane_range_of_5(w[0], w[1], w[2], w[4], w[5]);
    tf_lane_range all = tf_lane_common(tf_lane_common(ABb_CDd, ABb_Ccd),
                                       tf_lane_common(Aab_CDd, Aab_Ccd));
    found.agreement = tf_lane_agreement(all);
    found.conflict = tf_lane_conflict(all);
    found.sum = DCB + adc;
    return found;
}
