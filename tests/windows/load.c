// SPDX-License-Identifier: GPL-3.0-or-later
// Loads a library as Python loads modules: load.exe LIBRARY NAME. Prints what is wrong, and the number of what the
// library imports; 0 if all of that and NAME are there. Wine loads libraries that lack imports, Windows does not: so
// each one is looked for.
#include <stdio.h>
#include <windows.h>

static int missing(const BYTE *base, DWORD table, int *count) {
    int lacks = 0;
    const IMAGE_IMPORT_DESCRIPTOR *row = (const IMAGE_IMPORT_DESCRIPTOR *)(base + table);
    for (; row->Name; ++row) {
        const char *library = (const char *)(base + row->Name);
        const HMODULE loaded = GetModuleHandleA(library);
        const IMAGE_THUNK_DATA *entry = (const IMAGE_THUNK_DATA *)(base + row->OriginalFirstThunk);
        for (; entry->u1.AddressOfData; ++entry, ++*count) {
            const char *name = ((const IMAGE_IMPORT_BY_NAME *)(base + entry->u1.AddressOfData))->Name;
            if (IMAGE_SNAP_BY_ORDINAL(entry->u1.Ordinal)) name = (const char *)IMAGE_ORDINAL(entry->u1.Ordinal);
            if (loaded && GetProcAddress(loaded, name)) continue;
            printf("%s has no %s\n", library, IMAGE_SNAP_BY_ORDINAL(entry->u1.Ordinal) ? "such number" : name);
            ++lacks;
        }
    }
    return lacks;
}

int main(int count, char **words) {
    if (count != 3) return 2;
    const BYTE *base = (const BYTE *)LoadLibraryA(words[1]);
    if (!base) {
        printf("%s is not loaded: error %lu\n", words[1], GetLastError());
        return 1;
    }
    const IMAGE_NT_HEADERS *header = (const IMAGE_NT_HEADERS *)(base + ((const IMAGE_DOS_HEADER *)base)->e_lfanew);
    int imports = 0;
    int lacks = missing(base, header->OptionalHeader.DataDirectory[IMAGE_DIRECTORY_ENTRY_IMPORT].VirtualAddress, &imports);
    if (!GetProcAddress((HMODULE)base, words[2])) printf("it has no %s\n", words[2]), ++lacks;
    printf("%d imports\n", imports);
    return lacks ? 1 : 0;
}
