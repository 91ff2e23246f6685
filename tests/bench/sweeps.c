// How many sweeps of projected Gauss-Seidel a round of zones should have: the
// steps of scenes of cloth, resolved with few sweeps and with many, and with
// conjugate residuals:
//
//     sweeps [--csv]
//
// Prints a line a scene and number of sweeps: rounds of zones in a step, mean
// and most; steps that needed the failsafe; sweeps, times the zones that had
// them, in thousands; the sum of the energies that steps ended with, relative to
// what was proposed, and how often a step ended with more than was proposed; the
// seconds of processor time for resolving.  With --csv lines "name,value,unit".

#include "bench/measuring.h"
#include "response/conjugate_residuals.h"
#include "response/gauss_seidel.h"
#include "response/resolve.h"
#include "support/cloth.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct tally {
    int steps, rounds, most_rounds, rescued, risen;
    double iterations, before, after, time;
} tally;

static void account(const tf_response_report *report, tally *sum)
{
    int rounds = report->rounds[TF_ZONES];
    sum->steps++;
    sum->rounds += rounds;
    sum->most_rounds = rounds > sum->most_rounds ? rounds : sum->most_rounds;
    sum->rescued += report->rounds[TF_FAILSAFE] > 0;
    sum->risen += report->energy_after > report->energy_before * (1 + 1e-9);
    sum->iterations += (double)report->iterations;
    sum->before += report->energy_before;
    sum->after += report->energy_after;
}

static tally run(cloth_scene which, int edges, int steps,
                 const tf_zone_solver *solver, int sweeps)
{
    const tf_response_options options = {.solver = solver, .sweeps = sweeps};
    cloth_model *cloth = cloth_new(which, edges);
    tf_surface *surface;
    tf_resolver *resolver;
    double *end =
        malloc(sizeof *end * (size_t)(cloth->mesh.axes * cloth->mesh.vertices));
    require(end ? TF_OK : TF_OUT_OF_MEMORY);
    require(tf_surface_create(&cloth->mesh, &surface, NULL));
    require(tf_resolver_create(surface, &resolver));
    tally sum = {0};
    for (int i = 0; i < steps; i++) {
        const tf_response_report *report;
        cloth_propose(cloth, end);
        double begin = processor_seconds();
        require(tf_step_resolve(resolver, cloth->mesh.vertices, cloth->position,
                                end, cloth->inverse_mass, &options, &report,
                                NULL));
        sum.time += processor_seconds() - begin;
        account(report, &sum);
        cloth_accept(cloth, tf_resolver_unpushed(resolver), end);
    }
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    cloth_free(cloth);
    free(end);
    return sum;
}

static void print(bool csv, const char *scene, const char *solver, int sweeps,
                  const tally *sum)
{
    double rounds = (double)sum->rounds / sum->steps;
    double kept = sum->after / sum->before;
    if (!csv) {
        printf("%-14s %-20s %4d  %6.2f %4d %4d %8.0f %6.3f %4d %7.2f\n", scene,
               solver, sweeps, rounds, sum->most_rounds, sum->rescued,
               sum->iterations / 1000, kept, sum->risen, sum->time);
        fflush(stdout);
        return;
    }
    char name[64];
    snprintf(name, sizeof name, "%s %s %d", scene, solver, sweeps);
    printf("%s rounds,%.2f,\n", name, rounds);
    printf("%s most rounds,%d,\n", name, sum->most_rounds);
    printf("%s failsafe,%d,\n", name, sum->rescued);
    printf("%s iterations,%.0f,\n", name, sum->iterations);
    printf("%s energy,%.3f,\n", name, kept);
    printf("%s risen,%d,\n", name, sum->risen);
    printf("%s time,%.2f,s\n", name, sum->time);
}

int main(int argc, char *argv[])
{
    static const struct {
        cloth_scene scene;
        int edges, steps;
    } scenes[] = {{CHAIN, 300, 120}, {SPHERE, 34, 120}, {TWIST, 15, 200}};
    static const struct {
        const tf_zone_solver *solver;
        int sweeps;
    } ways[] = {{&tf_gauss_seidel, 5},         {&tf_gauss_seidel, 20},
                {&tf_gauss_seidel, 60},        {&tf_gauss_seidel, 200},
                {&tf_gauss_seidel, 600},       {&tf_conjugate_residuals, 60},
                {&tf_conjugate_residuals, 600}};
    bool csv = argc > 1 && strcmp(argv[1], "--csv") == 0;
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++)
        for (size_t j = 0; j < sizeof ways / sizeof *ways; j++) {
            tally sum = run(scenes[i].scene, scenes[i].edges, scenes[i].steps,
                            ways[j].solver, ways[j].sweeps);
            print(csv, cloth_names[scenes[i].scene], ways[j].solver->name,
                  ways[j].sweeps, &sum);
        }
    return EXIT_SUCCESS;
}
