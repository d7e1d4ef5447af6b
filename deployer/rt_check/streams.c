/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
/*
 * Streams of the C library, so std::cout too. They lock, and write when they are full or at the end of a line; both happens
 * inside libc, where nobody can stand in front of it. So each use counts.
 */
#include "in_front.h"

#undef __OPTIMIZE__ /* stdio.h is to declare functions, not to define some of them inline */
#include <stdarg.h>
#include <stdio.h>
#include <syslog.h>
#include <wchar.h>

/* clang-format off */
OROFORGE_WATCH(STREAM, size_t, fwrite, (const void* from, size_t size, size_t n, FILE* f), (from, size, n, f))
OROFORGE_WATCH(STREAM, size_t, fread, (void* to, size_t size, size_t n, FILE* f), (to, size, n, f))
OROFORGE_WATCH(STREAM, int, fflush, (FILE* f), (f))
OROFORGE_WATCH(STREAM, int, fputs, (const char* text, FILE* f), (text, f))
OROFORGE_WATCH(STREAM, int, puts, (const char* text), (text))
OROFORGE_WATCH(STREAM, int, fputc, (int c, FILE* f), (c, f))
OROFORGE_WATCH(STREAM, int, putc, (int c, FILE* f), (c, f))
OROFORGE_WATCH(STREAM, int, putchar, (int c), (c))
OROFORGE_WATCH(STREAM, char*, fgets, (char* to, int size, FILE* f), (to, size, f))
OROFORGE_WATCH(STREAM, int, fgetc, (FILE* f), (f))
OROFORGE_WATCH(STREAM, int, getc, (FILE* f), (f))
OROFORGE_WATCH(STREAM, int, getchar, (void), ())
OROFORGE_WATCH(STREAM, __ssize_t, getline, (char** line, size_t* size, FILE* f), (line, size, f))
OROFORGE_WATCH(STREAM, __ssize_t, getdelim, (char** line, size_t* size, int end, FILE* f), (line, size, end, f))
OROFORGE_WATCH(STREAM, __ssize_t, __getdelim, (char** line, size_t* size, int end, FILE* f), (line, size, end, f))
OROFORGE_WATCH(STREAM, int, ungetc, (int c, FILE* f), (c, f))
OROFORGE_WATCH(STREAM, size_t, fwrite_unlocked, (const void* from, size_t size, size_t n, FILE* f), (from, size, n, f))
OROFORGE_WATCH(STREAM, size_t, fread_unlocked, (void* to, size_t size, size_t n, FILE* f), (to, size, n, f))
OROFORGE_WATCH(STREAM, int, fflush_unlocked, (FILE* f), (f))
OROFORGE_WATCH(STREAM, int, fputs_unlocked, (const char* text, FILE* f), (text, f))
OROFORGE_WATCH(STREAM, wint_t, fputwc, (wchar_t c, FILE* f), (c, f))
OROFORGE_WATCH(STREAM, wint_t, putwc, (wchar_t c, FILE* f), (c, f))
OROFORGE_WATCH(STREAM, wint_t, fgetwc, (FILE* f), (f))
OROFORGE_WATCH(STREAM, wint_t, getwc, (FILE* f), (f))
OROFORGE_WATCH(STREAM, wint_t, ungetwc, (wint_t c, FILE* f), (c, f))
OROFORGE_WATCH(STREAM, int, fputws, (const wchar_t* text, FILE* f), (text, f))
OROFORGE_WATCH(STREAM, wchar_t*, fgetws, (wchar_t* to, int size, FILE* f), (to, size, f))
OROFORGE_WATCH(STREAM, int, fseeko, (FILE* f, off_t at, int from), (f, at, from))
OROFORGE_WATCH(STREAM, int, fseeko64, (FILE* f, off64_t at, int from), (f, at, from))
OROFORGE_WATCH(STREAM, FILE*, tmpfile, (void), ())
OROFORGE_WATCH(STREAM, FILE*, tmpfile64, (void), ())
OROFORGE_WATCH(STREAM, int, fseek, (FILE* f, long at, int from), (f, at, from))
OROFORGE_WATCH_IF(STREAM, FILE*, fopen, (const char* path, const char* mode), (path, mode), OROFORGE_NOTE_PATH(path, "fopen"))
OROFORGE_WATCH_IF(STREAM, FILE*, fopen64, (const char* path, const char* mode), (path, mode), OROFORGE_NOTE_PATH(path, "fopen64"))
OROFORGE_WATCH(STREAM, FILE*, freopen, (const char* path, const char* mode, FILE* f), (path, mode, f))
OROFORGE_WATCH(STREAM, FILE*, freopen64, (const char* path, const char* mode, FILE* f), (path, mode, f))
OROFORGE_WATCH(STREAM, FILE*, fdopen, (int fd, const char* mode), (fd, mode))
OROFORGE_WATCH(STREAM, int, fclose, (FILE* f), (f))
OROFORGE_WATCH(STREAM, FILE*, popen, (const char* command, const char* mode), (command, mode))
OROFORGE_WATCH(STREAM, int, pclose, (FILE* f), (f))
OROFORGE_WATCH(STREAM, int, vprintf, (const char* format, va_list list), (format, list))
OROFORGE_WATCH(STREAM, int, vfprintf, (FILE* f, const char* format, va_list list), (f, format, list))
OROFORGE_WATCH(STREAM, int, vdprintf, (int fd, const char* format, va_list list), (fd, format, list))
OROFORGE_WATCH(STREAM, int, vwprintf, (const wchar_t* format, va_list list), (format, list))
OROFORGE_WATCH(STREAM, int, vfwprintf, (FILE* f, const wchar_t* format, va_list list), (f, format, list))

/* What the scanf functions are since C99. */
extern int __isoc99_vscanf(const char*, va_list);
extern int __isoc99_vfscanf(FILE*, const char*, va_list);
OROFORGE_WATCH(STREAM, int, __isoc99_vscanf, (const char* format, va_list list), (format, list))
OROFORGE_WATCH(STREAM, int, __isoc99_vfscanf, (FILE* f, const char* format, va_list list), (f, format, list))

/* Called instead where a package is built with _FORTIFY_SOURCE. */
extern int __vprintf_chk(int, const char*, va_list);
extern int __vfprintf_chk(FILE*, int, const char*, va_list);
extern void __vsyslog_chk(int, int, const char*, va_list);
extern char* __fgets_chk(char*, size_t, int, FILE*);
extern size_t __fread_chk(void*, size_t, size_t, size_t, FILE*);
OROFORGE_WATCH(STREAM, int, __vprintf_chk, (int level, const char* format, va_list list), (level, format, list))
OROFORGE_WATCH(STREAM, int, __vfprintf_chk, (FILE* f, int level, const char* format, va_list list), (f, level, format, list))
OROFORGE_WATCH(STREAM, char*, __fgets_chk, (char* to, size_t room, int size, FILE* f), (to, room, size, f))
OROFORGE_WATCH(STREAM, size_t, __fread_chk, (void* to, size_t room, size_t size, size_t n, FILE* f), (to, room, size, n, f))
/* clang-format on */

/* Those with "…" go on to their sister with a list. */
#define WITH_LIST(NAME, PARAMETERS, LAST, SISTER, ARGUMENTS)      \
    OROFORGE_IN_FRONT int NAME PARAMETERS {                       \
        OROFORGE_COUNT(STREAM, #NAME);                            \
        va_list list;                                             \
        va_start(list, LAST);                                     \
        const int result = OROFORGE_NEXT_OF(SISTER, 0) ARGUMENTS; \
        va_end(list);                                             \
        OROFORGE_COUNTED();                                       \
        return result;                                            \
    }
WITH_LIST(printf, (const char* format, ...), format, vprintf, (format, list))
WITH_LIST(fprintf, (FILE * f, const char* format, ...), format, vfprintf, (f, format, list))
WITH_LIST(dprintf, (int fd, const char* format, ...), format, vdprintf, (fd, format, list))
WITH_LIST(wprintf, (const wchar_t* format, ...), format, vwprintf, (format, list))
WITH_LIST(fwprintf, (FILE * f, const wchar_t* format, ...), format, vfwprintf, (f, format, list))
extern int __isoc99_scanf(const char*, ...);
extern int __isoc99_fscanf(FILE*, const char*, ...);
WITH_LIST(__isoc99_scanf, (const char* format, ...), format, __isoc99_vscanf, (format, list))
WITH_LIST(__isoc99_fscanf, (FILE * f, const char* format, ...), format, __isoc99_vfscanf, (f, format, list))
WITH_LIST(__printf_chk, (int level, const char* format, ...), format, __vprintf_chk, (level, format, list))
WITH_LIST(__fprintf_chk, (FILE * f, int level, const char* format, ...), format, __vfprintf_chk,
          (f, level, format, list))

OROFORGE_IN_FRONT void rewind(FILE* f) {
    OROFORGE_COUNT(STREAM, "rewind");
    OROFORGE_NEXT_OF(rewind, 0)(f);
    OROFORGE_COUNTED();
}

OROFORGE_IN_FRONT void flockfile(FILE* f) {
    OROFORGE_COUNT(LOCK, "flockfile");
    OROFORGE_NEXT_OF(flockfile, 0)(f);
    OROFORGE_COUNTED();
}

OROFORGE_IN_FRONT void perror(const char* text) {
    OROFORGE_COUNT(STREAM, "perror");
    OROFORGE_NEXT_OF(perror, 0)(text);
    OROFORGE_COUNTED();
}

OROFORGE_IN_FRONT void vsyslog(int priority, const char* format, va_list list) {
    OROFORGE_COUNT(STREAM, "vsyslog");
    OROFORGE_NEXT_OF(vsyslog, 0)(priority, format, list);
    OROFORGE_COUNTED();
}

OROFORGE_IN_FRONT void syslog(int priority, const char* format, ...) {
    OROFORGE_COUNT(STREAM, "syslog");
    va_list list;
    va_start(list, format);
    OROFORGE_NEXT_OF(vsyslog, 0)(priority, format, list);
    va_end(list);
    OROFORGE_COUNTED();
}

extern void __syslog_chk(int, int, const char*, ...);
OROFORGE_IN_FRONT void __syslog_chk(int priority, int level, const char* format, ...) {
    OROFORGE_COUNT(STREAM, "syslog");
    va_list list;
    va_start(list, format);
    OROFORGE_NEXT_OF(__vsyslog_chk, 0)(priority, level, format, list);
    va_end(list);
    OROFORGE_COUNTED();
}
