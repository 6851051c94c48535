// The worst that one pupil, or one teacher's browser, can send to a server.
import { randomBytes } from 'node:crypto'
import { Client, projectOfLesson } from '@botgarten/server/rehearsal'
import { everyMs, joined, type OpenClass } from './setting.ts'

interface Target {
  readonly url: string
  readonly class: OpenClass
  /** Signed in as the teacher of the class. */
  readonly teacher: Client
  /** The one who attacks. */
  readonly pupil: Client
  readonly signal: AbortSignal
  /** Counts an answer by its status. */
  readonly count: (status: number) => void
}

/** Prepares an attack. @returns a function that attacks until the signal */
type Attack = (target: Target) => Promise<() => Promise<unknown>>

interface Lesson {
  readonly programs: { readonly main: { readonly stacks: readonly { readonly blocks: readonly Block[] }[] } }
}
interface Block {
  readonly id: string
  readonly values: { readonly [name: string]: object }
}

/** A program of 20,000 blocks, 4.7 MB: the parser takes the longest for it. */
function largeProgram(name: string): string {
  const lesson = JSON.parse(projectOfLesson(name, 0)) as Lesson
  const few = lesson.programs.main.stacks[0]!.blocks
  const copy = ({ id, values, ...block }: Block, at: number) => ({
    ...{ ...block, id: `${id}-${at}` },
    values: Object.fromEntries(
      Object.entries(values).map(([of, value]) => [of, { ...value, id: `${id}-${of}-${at}` }]),
    ),
  })
  const blocks = Array.from({ length: 70 }, (_, at) => few.map((block) => copy(block, at))).flat()
  const main = { ...lesson.programs.main, stacks: [{ x: 0, y: 0, blocks }] }
  return JSON.stringify({ ...lesson, programs: { main } })
}

/** A project with a picture of 4.7 MB that no other project has. */
function largePicture(name: string): string {
  const start = Buffer.from('iVBORw0KGgo=', 'base64')
  const picture = Buffer.concat([start, randomBytes(3_500_000)]).toString('base64')
  const lesson = JSON.parse(projectOfLesson(name, 0)) as object
  return JSON.stringify({ ...lesson, assets: { ['a'.repeat(64)]: { type: 'image/png', base64: picture } } })
}

const large = (at: number) => (at % 2 === 0 ? largeProgram : largePicture)(`Garden ${at}`)

const asked = async ({ count }: Target, client: Client, ...request: Parameters<Client['ask']>) => {
  const { status, body } = await client.ask(...request)
  count(status)
  return { status, body }
}

/** As many at once, each again and again. */
const atOnce = (many: number, target: Target, act: (at: number, count: number) => Promise<unknown>) =>
  Promise.all(Array.from({ length: many }, (_, at) => everyMs(100, target.signal, (count) => act(at, count))))

const streams: Attack = (target) => {
  const { pupil } = target
  const headers = { cookie: [...pupil.cookies].map(([name, value]) => `${name}=${value}`).join('; ') }
  const one = async () => {
    const answer = await fetch(`${target.url}/api/class/me/stream`, { headers, signal: target.signal })
    target.count(answer.status)
    for await (const _ of answer.body ?? []);
  }
  const move = (count: number) => pupil.ask('PUT', '/me/hand', { up: count % 2 === 0 })
  return Promise.resolve(() =>
    Promise.all([
      // Those that are refused try again, each every 10 s.
      ...Array.from({ length: 1000 }, () => everyMs(10_000, target.signal, one)),
      everyMs(200, target.signal, move),
    ]),
  )
}

const hands: Attack = (target) => {
  const move = (at: number, count: number) =>
    asked(target, target.pupil, 'PUT', '/me/hand', { up: (at + count) % 2 === 0 })
  // 20 every 100 ms.
  return Promise.resolve(() => atOnce(20, target, move))
}

const hearts: Attack = async (target) => {
  const maker = await joined(target.url, target.class, 'Maker')
  const { id } = await maker.untilDone<{ id: string }>(
    'POST',
    '/gallery?share=worst-share',
    projectOfLesson('Shared', 0),
  )
  const give = (at: number, count: number) =>
    asked(target, target.pupil, 'PUT', `/gallery/${id}/heart`, { on: (at + count) % 2 === 0 })
  return () => atOnce(20, target, give)
}

const uploads: Attack = (target) => {
  const texts = Array.from({ length: 4 }, (_, at) => large(at))
  const send = (at: number, count: number) =>
    asked(
      ...[target, target.pupil, 'PUT' as const],
      `/projects/upload-${at}?base=${count}&save=upload-${at}-${count}`,
      texts[(at + count) % texts.length],
    )
  return Promise.resolve(() => atOnce(40, target, send))
}

const joins: Attack = (target) => {
  let made = 0
  const one = async () => {
    // Each is a new device: it has no cookie.
    const nickname = `Kind ${++made}`
    await asked(target, new Client(target.url), 'POST', '/join', { code: target.class.code, nickname })
  }
  return Promise.resolve(() => atOnce(8, target, one))
}

const projects: Attack = (target) => {
  let made = 0
  const one = async () => {
    const at = made++
    await asked(target, target.pupil, 'PUT', `/projects/project-${at}?base=0&save=project-${at}`, large(at))
  }
  return Promise.resolve(() => atOnce(2, target, one))
}

const exports: Attack = async (target) => {
  // Ten pupils, each with one of the largest projects.
  for (let at = 0; at < 10; at++) {
    const pupil = await joined(target.url, target.class, `Exports ${at}`)
    await pupil.untilDone('PUT', `/projects/export-${at}?base=0&save=export-${at}`, large(at))
  }
  const headers = { cookie: [...target.teacher.cookies].map((one) => one.join('=')).join('; ') }
  const one = async () => {
    const path = `/api/class/classes/${target.class.id}/export`
    const answer = await fetch(`${target.url}${path}`, { headers, signal: target.signal })
    target.count(answer.status)
    for await (const _ of answer.body ?? []);
  }
  return () => atOnce(20, target, one)
}

/** By their names in the table. */
export const attacks = {
  '1,000 streams': streams,
  '200 hand moves a second': hands,
  '200 hearts a second': hearts,
  '40 uploads of 4.8 MB at once': uploads,
  '1,500 joins': joins,
  '130 projects of 4.8 MB': projects,
  '20 exports at once': exports,
} as const satisfies { readonly [name: string]: Attack }

export type AttackName = keyof typeof attacks
