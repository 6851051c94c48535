import { correction, generate } from 'lean-qr'

/** A code to point a phone at, drawn with letters: dark modules are left free, for terminals are dark. */
export const codeInTerminal = (address: string): string =>
  generate(address, { minCorrectionLevel: correction.L }).toString({ on: '  ', off: '██', pad: 2 })
