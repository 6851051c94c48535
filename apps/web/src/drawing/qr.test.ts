import { createRequire } from 'node:module'
import { expect, test } from 'vitest'
import { drawQr, drawWifi } from './qr.ts'

// It is not a module of today: what it exports is beside, not in, what `import` would give.
const jsQR = (createRequire(import.meta.url)('jsqr') as typeof import('jsqr')).default

/** Paints the outline of a code (M, L, H, V, Z over whole modules) by the even-odd rule, `scale` pixels a module. */
function pixelsOf({ path, viewBox }: ReturnType<typeof drawQr>, scale: number) {
  const [left, top, side] = viewBox.split(' ').map(Number) as [number, number, number]
  const size = side * scale
  const pixels = new Uint8ClampedArray(size * size * 4).fill(255)
  const edges = uprightEdges(path)
  for (let y = 0; y < size; y++)
    for (let x = 0; x < size; x++) {
      const [mx, my] = [left + (x + 0.5) / scale, top + (y + 0.5) / scale]
      const crossed = edges.filter((edge) => edge.x < mx && edge.from < my && my < edge.to).length
      if (crossed % 2 === 1) pixels.fill(0, (y * size + x) * 4, (y * size + x) * 4 + 3)
    }
  return { pixels, size }
}

/** All vertical edges of an outline. */
function uprightEdges(path: string): readonly { x: number; from: number; to: number }[] {
  const edges: { x: number; from: number; to: number }[] = []
  let [x, y, startX, startY] = [0, 0, 0, 0]
  const to = (newX: number, newY: number) => {
    if (newY !== y) edges.push({ x, from: Math.min(y, newY), to: Math.max(y, newY) })
    ;[x, y] = [newX, newY]
  }
  for (const [, letter, text = ''] of path.matchAll(/([a-zA-Z])([^a-zA-Z]*)/g)) {
    const numbers = text.match(/-?[\d.]+/g)?.map(Number) ?? []
    if (letter === 'M') [x, y, startX, startY] = [numbers[0]!, numbers[1]!, numbers[0]!, numbers[1]!]
    else if (letter === 'L') to(numbers[0]!, numbers[1]!)
    else if (letter === 'H') to(numbers[0]!, y)
    else if (letter === 'V') to(x, numbers[0]!)
    else if (letter === 'h') to(x + numbers[0]!, y)
    else if (letter === 'v') to(x, y + numbers[0]!)
    else if (letter === 'Z' || letter === 'z') to(startX, startY)
    else throw new Error(`This outline has "${letter}".`)
  }
  return edges
}

test.each([
  'https://botgarten.example.org/lab/friendship',
  'https://schule.example/botgarten/lab/loud-distance/',
  'http://192.168.178.40:4173/lab/railway',
  'https://straße.example/lab/chameleon',
  `https://a-very-long-name.of-a-school.example.org/${'folder/'.repeat(20)}materials/card/q-railway`,
])('another decoder reads %s back', (address) => {
  const { pixels, size } = pixelsOf(drawQr(address), 4)
  expect(jsQR(pixels, size, size)?.data).toBe(new URL(address).href)
})

test.each([
  ['Botgarten', 'sonnenblume', 'WIFI:T:WPA;S:Botgarten;P:sonnenblume;;'],
  ['Aula "Süd"; 2', 'a:b\\c,d;e', String.raw`WIFI:T:WPA;S:Aula \"Süd\"\; 2;P:a\:b\\c\,d\;e;;`],
  ['Gäste', '', 'WIFI:T:nopass;S:Gäste;;'],
])('another decoder reads the Wi-Fi %s back', (name, password, text) => {
  const { pixels, size } = pixelsOf(drawWifi(name, password), 4)
  expect(jsQR(pixels, size, size)?.data).toBe(text)
})

test('a code that is dirty on a sixteenth of its face still says its address', () => {
  const address = 'https://botgarten.example.org/lab/friendship'
  const { pixels, size } = pixelsOf(drawQr(address), 4)
  const dirt = Math.round(size / 4)
  const from = Math.round(size * 0.45)
  for (let y = from; y < from + dirt; y++) pixels.fill(0, (y * size + from) * 4, (y * size + from + dirt) * 4)
  for (let index = 3; index < pixels.length; index += 4) pixels[index] = 255
  expect(jsQR(pixels, size, size)?.data).toBe(address)
})

test('a white edge of four modules is around it', () => {
  const { viewBox } = drawQr('https://botgarten.example.org/')
  const [left, top, side] = viewBox.split(' ').map(Number) as [number, number, number]
  expect([left, top]).toEqual([-4, -4])
  expect((side - 8 - 21) % 4).toBe(0)
})
