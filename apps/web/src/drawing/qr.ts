import { correction, generate } from 'lean-qr'
import { toSvgPath } from 'lean-qr/extras/svg'

/** A code as a drawing: black modules of side 1, with the white edge of four that readers ask for. */
export interface QrDrawing {
  readonly path: string
  readonly viewBox: string
}

const quiet = 4

/**
 * The code of an address (QR, ISO/IEC 18004). A seventh of it may be dirty or folded (level M).
 * @throws TypeError for what is no address
 */
export function drawQr(address: string): QrDrawing {
  // As browsers write it: readers differ on letters beyond ASCII.
  const code = generate(new URL(address).href, { minCorrectionLevel: correction.M })
  const side = code.size + 2 * quiet
  return { path: toSvgPath(code), viewBox: `${-quiet} ${-quiet} ${side} ${side}` }
}
