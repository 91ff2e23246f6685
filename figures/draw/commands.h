// The commands of tanglefree-draw.
#ifndef TF_DRAW_COMMANDS_H
#define TF_DRAW_COMMANDS_H

// Each understands its arguments, of which argv[0] is its name in messages,
// and returns the exit status.
int tf_draw_figure(int argc, char *argv[]);
int tf_draw_list(int argc, char *argv[]);
int tf_draw_query(int argc, char *argv[]);

#endif
