// A libcuda.so between LLVM's offload runtime and the driver, which puts an image back into the layout that CUDA 13 wrote it in
// (scripts/gpu/earlier_layout.py) when it is loaded. gpu_visit takes it if a driver refuses images in the earlier layout,
// which nobody has seen yet: the first visit that shows which of the two works makes the other one superfluous.
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include <dlfcn.h>
#include <elf.h>

namespace {

/// Bytes from the header to the end of the last section or table.
std::size_t size_of(const unsigned char* image) {
  Elf64_Ehdr header;
  std::memcpy(&header, image, sizeof header);
  std::size_t end = header.e_shoff + std::size_t{header.e_shentsize} * header.e_shnum;
  const auto* sections = reinterpret_cast<const Elf64_Shdr*>(image + header.e_shoff);
  for (int i = 0; i < header.e_shnum; ++i)
    if (sections[i].sh_type != SHT_NOBITS && sections[i].sh_offset + sections[i].sh_size > end)
      end = sections[i].sh_offset + sections[i].sh_size;
  const std::size_t segments = header.e_phoff + std::size_t{header.e_phentsize} * header.e_phnum;
  return segments > end ? segments : end;
}

std::vector<unsigned char> restored(const unsigned char* image) {
  std::vector<unsigned char> copy(image, image + size_of(image));
  auto* header = reinterpret_cast<Elf64_Ehdr*>(copy.data());
  header->e_ident[EI_OSABI] = 0x41;
  header->e_ident[EI_ABIVERSION] = 8;
  header->e_version = 1;
  header->e_flags = 0x06000004 | (header->e_flags & 0xff) << 8;
  auto* sections = reinterpret_cast<Elf64_Shdr*>(copy.data() + header->e_shoff);
  const char* names = reinterpret_cast<const char*>(copy.data() + sections[header->e_shstrndx].sh_offset);
  for (int i = 0; i < header->e_shnum; ++i)
    if (std::string_view(names + sections[i].sh_name).substr(0, 6) == ".text.") sections[i].sh_flags &= 0xfffff;
  return copy;
}

}  // namespace

extern "C" int cuModuleLoadDataEx(void** module, const unsigned char* image, unsigned num_options, int* options, void** values) {
  using Load = int (*)(void**, const void*, unsigned, int*, void**);
  static const Load load = reinterpret_cast<Load>(dlsym(dlopen("libcuda.so.1", RTLD_LAZY), "cuModuleLoadDataEx"));
  return load(module, image[EI_ABIVERSION] == 7 ? restored(image).data() : image, num_options, options, values);
}
