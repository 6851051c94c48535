/** Poses of Bo, as the drawings of `sprites.svg`: what differs from pose to pose. */
export type BoPose = 'wave' | 'think' | 'oops' | 'cheer'

interface Hand {
  readonly arm: string
  readonly x: number
  readonly y: number
}

interface BoDrawing {
  /** x, y, width and height of the drawing. */
  readonly box: readonly [number, number, number, number]
  /** Degrees the whole body leans, and px it is off the ground. */
  readonly lean: number
  readonly lift: number
  readonly head: number
  readonly sprout: number
  readonly mouth: string
  /** What the sprout sways about, and what open eyes close towards: shares of the drawing, as CSS has them. */
  readonly root: string
  readonly pupils?: string
  readonly left: Hand
  readonly right: Hand
}

export const boDrawings: { readonly [pose in BoPose]: BoDrawing } = {
  wave: {
    box: [0, -34, 204, 252],
    lean: 0,
    lift: 0,
    head: -3,
    sprout: 6,
    mouth: 'M93 80q7 7 14 0',
    root: '47.07% 25.44%',
    pupils: '47.57% 38.93%',
    left: { arm: 'M56 132C34 140 26 152 22 164', x: 21, y: 168 },
    right: { arm: 'M144 130C168 122 176 104 178 84', x: 179, y: 78 },
  },
  think: {
    box: [0, -34, 214, 252],
    lean: 0,
    lift: 0,
    head: 4,
    sprout: 14,
    mouth: 'M95 82q6-3 11 0',
    root: '49.21% 25.47%',
    pupils: '47.9% 38.52%',
    left: { arm: 'M56 136C38 142 32 154 34 168', x: 35, y: 172 },
    right: { arm: 'M144 136C164 142 162 118 140 108', x: 134, y: 106 },
  },
  oops: {
    box: [-24, -34, 236, 252],
    lean: -9,
    lift: 0,
    head: -15,
    sprout: -24,
    mouth: 'M90 83q4-5 7.5 0t7.5 0',
    root: '32.82% 28.49%',
    left: { arm: 'M54 130C30 126 18 112 12 96', x: 11, y: 91 },
    right: { arm: 'M146 134C170 132 182 144 190 158', x: 192, y: 162 },
  },
  cheer: {
    box: [0, -34, 204, 252],
    lean: 0,
    lift: 14,
    head: 0,
    sprout: 0,
    mouth: '',
    root: '49.02% 19.84%',
    left: { arm: 'M56 130C32 120 24 100 22 78', x: 21, y: 72 },
    right: { arm: 'M144 130C168 120 176 100 178 78', x: 179, y: 72 },
  },
}
