// The commands of tanglefree-draw.
#ifndef FIG_DRAW_COMMANDS_H
#define FIG_DRAW_COMMANDS_H

// Each understands its arguments, of which argv[0] is its name in messages,
// and returns the exit status.
int fig_draw_figure(int argc, char *argv[]);
int fig_draw_film(int argc, char *argv[]);
int fig_draw_list(int argc, char *argv[]);
int fig_draw_query(int argc, char *argv[]);
int fig_draw_surface(int argc, char *argv[]);

#endif
