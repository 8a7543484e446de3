/* semihosting.h - calls that an emulator or a debugger serves: files and the end of the program. */
#ifndef SEMIHOSTING_H
#define SEMIHOSTING_H

enum semihosting_mode { SEMIHOSTING_READ = 0, SEMIHOSTING_APPEND = 8 };

/* A file of the host; negative when it cannot be opened. */
int semihosting_open(const char *name, enum semihosting_mode mode);

/* Bytes read, of at least one that is there; 0 at the end of the file. */
int semihosting_read(int file, void *bytes, int count);

void semihosting_write(int file, const void *bytes, int count);

/* Ends the emulator with that exit status. */
void semihosting_exit(int status);

#endif
