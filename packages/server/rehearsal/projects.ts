import { randomBytes } from 'node:crypto'

const bo = {
  ...{ id: 'bo', pose: { x: 50, y: 50, heading: 0 }, program: 'main', brain: '' },
  config: { wheelDiameter: 5.6, trackWidth: 11, sensors: {}, drive: { left: 'B', right: 'C' } },
}

const number = (id: string, value: number) => ({ id, type: 'math_number', fields: { NUM: String(value) } })

/** A program of a busy child: 60 kB of blocks. */
const blocks = Array.from({ length: 290 }, (_, at) => ({
  ...{ id: `b${at}`, type: 'robActions_play_tone' },
  values: { FREQUENCE: number(`f${at}`, 300 + at), DURATION: number(`d${at}`, 100) },
}))

const body = {
  ...{ botgarten: 1, card: 'friendship', brains: {} },
  programs: { main: { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } } },
  world: {
    ...{ size: { width: 200, height: 150 }, floor: { colour: '#ffffff' } },
    ...{ areas: [], lines: [], obstacles: [], robots: [bo] },
  },
}

/** Bytes that begin as a picture does; no two are alike. */
const picture = (bytes: number) => ({
  type: 'image/png',
  base64: Buffer.concat([Buffer.from('iVBORw0KGgo=', 'base64'), randomBytes(bytes)]).toString('base64'),
})

/** A project as a lesson has it: 60 kB, one in twenty with a picture of its own, 1 MB. */
export function projectOfLesson(mark: string, at: number): string {
  const assets = at % 20 === 19 ? { [randomBytes(32).toString('hex')]: picture(700_000) } : {}
  return JSON.stringify({ ...body, name: mark, assets })
}
