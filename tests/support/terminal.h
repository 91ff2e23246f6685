// A terminal that keeps what is written to it.
#ifndef SUPPORT_TERMINAL_H
#define SUPPORT_TERMINAL_H

typedef struct terminal {
    char name[100]; ///< of the file to write to
    int master, slave;
} terminal;

terminal terminal_open(void);

/// What has been written to the terminal, which is closed.  Does not wait for
/// anything to come.  The text is valid until the next call.
const char *terminal_close(terminal *screen);

/// Expects a line of progress in what a terminal showed, perhaps rewritten later
/// if the machine was slow, and erased at the end.
void expect_progress(const char *text, const char *line);

#endif
