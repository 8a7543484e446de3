/* commands.h - the subcommands: each takes its own arguments, argv[0] being its name, and returns the exit status. */
#ifndef COMMANDS_H
#define COMMANDS_H

int agile_eye_command(int argc, char **argv);
int arm_error_command(int argc, char **argv);
int compare_command(int argc, char **argv);
int dh_command(int argc, char **argv);
int fk_command(int argc, char **argv);
int ik_command(int argc, char **argv);
int hash_command(int argc, char **argv);
int solve_command(int argc, char **argv);
int study_command(int argc, char **argv);

extern const char agile_eye_help[];
extern const char arm_error_help[];
extern const char compare_help[];
extern const char dh_help[];
extern const char fk_help[];
extern const char ik_help[];
extern const char hash_help[];
extern const char solve_help[];
extern const char study_help[];

/* The message for an option that getopt_long did not accept; returns the exit status. `option` is what it returned,
 * '?' or ':' (the caller's short options start with a colon). */
int bad_option(int option, char **argv);

#endif
