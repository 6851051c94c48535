import { correction, generate, mode } from 'lean-qr'
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
  return draw(new URL(address).href)
}

const escaped = (text: string) => text.replaceAll(/[\\;,:"]/g, String.raw`\$&`)

/**
 * The code that lets a camera into a Wi-Fi (the form of ZXing, which Android and iOS read).
 * @param password empty: the Wi-Fi is open to all
 */
export function drawWifi(name: string, password: string): QrDrawing {
  const how = password === '' ? 'T:nopass' : 'T:WPA'
  const secret = password === '' ? '' : `P:${escaped(password)};`
  const text = `WIFI:${how};S:${escaped(name)};${secret};`
  // UTF-8 as plain bytes: not every reader knows the mark of a character set (ECI).
  return draw(mode.bytes(new TextEncoder().encode(text)))
}

function draw(data: Parameters<typeof generate>[0]): QrDrawing {
  const code = generate(data, { minCorrectionLevel: correction.M })
  const side = code.size + 2 * quiet
  return { path: toSvgPath(code), viewBox: `${-quiet} ${-quiet} ${side} ${side}` }
}
