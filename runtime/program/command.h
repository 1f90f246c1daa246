/* The subcommands of eom: each takes what stands behind its name, with the name itself as argv[0], and returns an exit status. */
#ifndef PROGRAM_COMMAND_H
#define PROGRAM_COMMAND_H

int info_command(int argc, char **argv);
int run_command(int argc, char **argv);
int linearise_command(int argc, char **argv);
int lyapunov_command(int argc, char **argv);
int compare_command(int argc, char **argv);
int watch_command(int argc, char **argv);

#endif
