// Headers: ELF (Tool Interface Standard 1.2), PE/COFF (Microsoft, revision 11), Mach-O (mach-o/loader.h).

const elfMachines: { readonly [code: number]: string } = { 0x3e: 'linux-x64', 0xb7: 'linux-arm64' }
const peMachines: { readonly [code: number]: string } = { 0x8664: 'windows-x64', 0xaa64: 'windows-arm64' }
const machMachines: { readonly [code: number]: string } = {
  0x01000007: 'macos-x64',
  0x0100000c: 'macos-arm64',
}

/** For which system and chip a program or library was made, such as `linux-arm64`; null where its header is none of ours. */
export function machineOf(bytes: Uint8Array): string | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  if (bytes.length < 64) return null
  // 0x7f E L F, in 64 bits
  if (view.getUint32(0) === 0x7f454c46) return elfMachines[view.getUint16(18, true)] ?? null
  if (view.getUint32(0, true) === 0xfeedfacf) return machMachines[view.getUint32(4, true)] ?? null
  // M Z: where the second header lies stands in the first.
  if (view.getUint16(0) !== 0x4d5a) return null
  const header = view.getUint32(60, true)
  if (header + 6 > bytes.length || view.getUint32(header) !== 0x50450000) return null
  return peMachines[view.getUint16(header + 4, true)] ?? null
}
