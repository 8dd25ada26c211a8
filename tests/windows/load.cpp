// SPDX-License-Identifier: GPL-3.0-or-later
// Loads a library as Python loads modules: load.exe LIBRARY NAME. Prints what is wrong, and the number of what the
// library imports; 0 if all of that and NAME are there. Wine loads libraries that lack imports, Windows does not: so
// each one is looked for.
#include <cstdio>
#include <windows.h>

namespace {

/// How many of a library's imports are nowhere; prints each. `table`: where they are; `count`: of them all.
int missing(const BYTE* base, DWORD table, int& count) {
    int lacks = 0;
    for (auto row = reinterpret_cast<const IMAGE_IMPORT_DESCRIPTOR*>(base + table); row->Name; ++row) {
        const auto library = reinterpret_cast<const char*>(base + row->Name);
        const HMODULE loaded = GetModuleHandleA(library);
        auto entry = reinterpret_cast<const IMAGE_THUNK_DATA*>(base + row->OriginalFirstThunk);
        for (; entry->u1.AddressOfData; ++entry, ++count) {
            const bool numbered = IMAGE_SNAP_BY_ORDINAL(entry->u1.Ordinal);
            const auto place = reinterpret_cast<const IMAGE_IMPORT_BY_NAME*>(base + entry->u1.AddressOfData);
            const char* name = numbered ? MAKEINTRESOURCEA(IMAGE_ORDINAL(entry->u1.Ordinal)) : place->Name;
            if (loaded && GetProcAddress(loaded, name)) continue;
            std::printf("%s has no %s\n", library, numbered ? "such number" : name);
            ++lacks;
        }
    }
    return lacks;
}

}  // namespace

int main(int count, char** words) {
    if (count != 3) return 2;
    const HMODULE module = LoadLibraryA(words[1]);
    if (!module) {
        std::printf("%s is not loaded: error %lu\n", words[1], GetLastError());
        return 1;
    }
    const auto base = reinterpret_cast<const BYTE*>(module);
    const auto start = reinterpret_cast<const IMAGE_DOS_HEADER*>(base);
    const auto header = reinterpret_cast<const IMAGE_NT_HEADERS*>(base + start->e_lfanew);
    const IMAGE_DATA_DIRECTORY& table = header->OptionalHeader.DataDirectory[IMAGE_DIRECTORY_ENTRY_IMPORT];
    int imports = 0, lacks = missing(base, table.VirtualAddress, imports);
    if (!GetProcAddress(module, words[2])) {
        std::printf("it has no %s\n", words[2]);
        ++lacks;
    }
    std::printf("%d imports\n", imports);
    return lacks ? 1 : 0;
}
