// Paints the canvases of a page beside it, so that the page itself has time for what a child does.
import type { Families } from '#drawing/shapes.ts'
import { Surface, type Frame } from '#drawing/surface.ts'
import { Receiver } from '#drawing/wire.ts'
import type { Face, Message, Painted } from './messages.ts'

interface Canvas {
  readonly surface: Surface
  readonly receiver: Receiver
  frame: Frame | null
  isPainted: boolean
  count: number
  isAwaited: boolean
}

const canvases = new Map<number, Canvas>()
const fonts = (self as unknown as { fonts: FontFaceSet }).fonts
const faces = new Set<string>()
/** One object for the same names and letters: who remembers a picture remembers by which it was painted. */
const families = new Map<string, Families>()
let arrivals = 0

// What comes while something is painted is taken first: of several frames only the last is painted.
const turns = new MessageChannel()
turns.port1.onmessage = () => {
  for (const [id, canvas] of canvases) if (!canvas.isPainted) paint(id, canvas)
}

function paint(id: number, canvas: Canvas): void {
  if (!canvas.frame) return
  canvas.isPainted = true
  canvas.surface.show({ ...canvas.frame, families: familiesOf(canvas.frame) })
  const { count } = canvas
  // With the next frame it has reached the screen.
  if (canvas.isAwaited) requestAnimationFrame(() => self.postMessage({ id, count } satisfies Painted))
}
const paintSoon = () => turns.port2.postMessage(null)

function familiesOf({ families: own }: Frame): Families {
  const names = `${own.title} ${own.read}`
  const known = families.get(names)
  if (known) return known
  // A canvas goes on with what it has found once under a name: names are others, by one that nothing has, when letters come.
  const renamed = (list: string) => `${list}, "arrival ${arrivals}"`
  const next = { title: renamed(own.title), read: renamed(own.read) }
  families.set(names, next)
  return next
}

function open(id: number, canvas: OffscreenCanvas): void {
  const surface = new Surface(canvas.getContext('2d')!, () => new OffscreenCanvas(1, 1).getContext('2d')!)
  canvases.set(id, {
    surface,
    receiver: new Receiver(),
    frame: null,
    isPainted: true,
    count: 0,
    isAwaited: false,
  })
}

async function loadFace({ family, source, weight }: Face): Promise<boolean> {
  const key = [family, source, weight].join()
  if (faces.has(key)) return false
  faces.add(key)
  const face = new FontFace(family, source, { weight })
  fonts.add(face)
  try {
    await face.load()
  } catch (error) {
    fonts.delete(face)
    faces.delete(key)
    throw error
  }
  return true
}

async function loadLetters(all: readonly Face[]): Promise<void> {
  const loaded = await Promise.allSettled(all.map(loadFace))
  if (!loaded.some((one) => one.status === 'fulfilled' && one.value)) return
  arrivals += 1
  families.clear()
  for (const canvas of canvases.values()) canvas.isPainted = false
  paintSoon()
}

self.onmessage = ({ data }: MessageEvent<Message>) => {
  if (data.kind === 'open') open(data.id, data.canvas)
  else if (data.kind === 'close') canvases.delete(data.id)
  else if (data.kind === 'letters') void loadLetters(data.faces)
  else {
    const canvas = canvases.get(data.id)
    if (!canvas) return
    const { count, isAwaited } = data
    Object.assign(canvas, { frame: canvas.receiver.receive(data.frame), isPainted: false, count, isAwaited })
    paintSoon()
  }
}
