import { setTimeout as wait } from 'node:timers/promises'
import type { RehearsalProgress } from '@botgarten/classroom'
import { Client } from './client.ts'
import { projectOfLesson } from './projects.ts'

export interface LessonOptions {
  readonly url: string
  /** Secret of the link for the first teacher. */
  readonly token: string
  readonly pupils: number
  readonly seconds: number
  /** Between two saves of a pupil, s. */
  readonly every: number
  /** Is told every second how it goes. */
  readonly hear?: (progress: RehearsalProgress) => void
  /** Ends the lesson early: it is then rejected. */
  readonly signal?: AbortSignal
}

export interface Figures {
  readonly pupils: number
  readonly saves: number
  /** Acknowledged saves that are not there at the end. */
  readonly lost: number
  /** 99 of 100 saves took at most so long, ms; and the slowest. */
  readonly p99: number
  readonly slowest: number
  /** Of the serving process with its workers at the most, and at the end of the first and of the last third, MB. */
  readonly rss: number
  readonly rssFirst: number
  readonly rssLast: number
  /** Requests that were sent again. */
  readonly again: number
  /** Bytes of events that the teacher was sent. */
  readonly heard: number
}

interface Child {
  readonly client: Client
  readonly at: number
  readonly project: string
  acknowledged: number
}

/** The value that a share of all do not exceed. */
function percentile(values: readonly number[], share: number): number {
  const sorted = values.toSorted((one, other) => one - other)
  return sorted[Math.max(0, Math.ceil(sorted.length * share) - 1)] ?? 0
}

async function openClass(teacher: Client, token: string): Promise<{ id: string; code: string }> {
  await teacher.untilDone('POST', '/teachers', { token, username: 'rehearsal', password: token })
  const endsOn = `${new Date().getFullYear() + 1}-07-31`
  const made = { name: 'Rehearsal', language: 'en', grade: 5, endsOn }
  const { id } = await teacher.untilDone<{ id: string }>('POST', '/classes', made)
  await teacher.untilDone('POST', `/classes/${id}/open`)
  const { words } = await teacher.untilDone<{ words: string[] }>('GET', `/classes/${id}`)
  return { id, code: words.join(' ') }
}

async function join({ url, signal }: LessonOptions, code: string, at: number): Promise<Child> {
  const client = new Client(url, signal)
  await client.untilDone('POST', '/join', { code, nickname: `Kind ${at}` })
  return { client, at, project: `rehearsal-${at}`, acknowledged: 0 }
}

const reportOf = (at: number) => ({
  ...{
    card: 'friendship',
    project: null,
    checks: ['passed', 'failed', 'open'],
    failed: at % 6,
    running: true,
  },
  ...{ idle: at % 200, size: [200, 150], pose: { x: at % 200, y: 40, heading: at / 10 } },
  trail: Array.from({ length: 120 }, (_, step) => (at + step) % 200),
})

const markOf = (count: number) => `save ${count}`

/** One save, sent until it is acknowledged. @returns how long that took, ms */
async function save(child: Child): Promise<number> {
  const count = child.acknowledged
  const path = `/projects/${child.project}?base=${count}&save=rehearsal-${count}`
  // Not all have their large save in the same moment.
  const text = projectOfLesson(markOf(count), count + child.at)
  const began = performance.now()
  await child.client.untilDone('PUT', path, text)
  child.acknowledged++
  return performance.now() - began
}

async function play(child: Child, at: number, options: LessonOptions, times: number[]) {
  const { pupils, every, seconds, signal } = options
  const pause = (time: number) => wait(time, undefined, signal && { signal })
  const end = performance.now() + seconds * 1000
  // Children do not save in the same moment.
  await pause((at / pupils) * every * 1000)
  for (let count = 0; performance.now() < end; count++) {
    const began = performance.now()
    times.push(await save(child))
    await child.client.untilDone('PUT', '/me/here', reportOf(count))
    await pause(Math.max(0, every * 1000 - (performance.now() - began)))
  }
}

/** Saves of a child that were acknowledged and are not there. */
async function lostOf({ client, project, acknowledged }: Child): Promise<number> {
  if (acknowledged === 0) return 0
  const path = `/projects/${project}`
  const found = await client.untilDone<{ revision: number; project: { name: string } }>('GET', path)
  const right = found.revision === acknowledged && found.project.name === markOf(acknowledged - 1)
  return right ? 0 : Math.max(1, acknowledged - found.revision)
}

const mb = (bytes: number) => Math.round(bytes / 1e6)

/** Looks at the memory of the server until it is stopped. */
function watch(teacher: Client, every: number) {
  const seen: number[] = []
  const timer = setInterval(() => {
    void teacher
      .ask<{ memory: number }>('GET', '/health')
      .then(({ status, body }) => void (status === 200 && seen.push(body.memory)))
      .catch(() => {})
  }, every)
  return {
    seen,
    stop: () => clearInterval(timer),
  }
}

/** Tells every second how far a lesson is. Returns how to stop. */
function tell(
  { hear, pupils, seconds }: LessonOptions,
  children: readonly Child[],
  times: readonly number[],
) {
  if (!hear) return { begins: () => {}, stop: () => {} }
  let began: number | null = null
  const now = () => {
    const played = began === null ? 0 : (performance.now() - began) / 1000
    const slowest = Math.round(Math.max(0, ...times))
    const progress = { pupils, joined: children.length, saves: times.length, slowest }
    hear({ ...progress, seconds: Math.min(seconds, Math.floor(played)), of: seconds })
  }
  now()
  const timer = setInterval(now, 1000)
  return { begins: () => void (began = performance.now()), stop: () => clearInterval(timer) }
}

const threeParts = (seen: readonly number[]) => {
  const third = Math.ceil(seen.length / 3)
  return {
    rss: mb(Math.max(0, ...seen)),
    rssFirst: mb(Math.max(0, ...seen.slice(0, third))),
    rssLast: mb(Math.max(0, ...seen.slice(-third))),
  }
}

/** A lesson through the real routes: pupils join, listen, report, save; the teacher watches. */
export async function playLesson(options: LessonOptions): Promise<Figures> {
  const { url, pupils, seconds, signal } = options
  const teacher = new Client(url, signal)
  const { id, code } = await openClass(teacher, options.token)
  const children: Child[] = []
  const times: number[] = []
  const telling = tell(options, children, times)
  const stops: (() => void)[] = [telling.stop]
  let heard = 0
  try {
    for (let at = 0; at < pupils; at++) children.push(await join(options, code, at))
    stops.push(
      teacher.listen(`/classes/${id}/stream`, (bytes) => void (heard += bytes)),
      ...children.map(({ client }) => client.listen('/me/stream')),
    )
    const memory = watch(teacher, Math.min(2000, (seconds * 1000) / 12))
    stops.push(memory.stop)
    telling.begins()
    await Promise.all(children.map((child, at) => play(child, at, options, times)))
    for (const stop of stops.splice(0)) stop()
    const lost = await Promise.all(children.map(lostOf))
    return {
      ...{ pupils, saves: times.length, lost: lost.reduce((sum, one) => sum + one, 0) },
      ...{ p99: Math.round(percentile(times, 0.99) * 10) / 10, slowest: Math.round(Math.max(0, ...times)) },
      ...threeParts(memory.seen),
      again: children.reduce((sum, { client }) => sum + client.again, 0),
      heard,
    }
  } finally {
    for (const stop of stops) stop()
  }
}
