// The other class: pupils whose pages save, report and read as lab pages do. Only their times are measured.
import { setTimeout as wait } from 'node:timers/promises'
import { Client, projectOfLesson } from '@botgarten/server/rehearsal'
import { everyMs, joined, type OpenClass } from './setting.ts'

/** Between two saves of a pupil, ms. */
const every = 5000

/** An answered request of a pupil. */
export interface Answered {
  readonly kind: 'save' | 'read'
  /** ms */
  readonly took: number
  readonly isRefused: boolean
}

const reportOf = (count: number) => ({
  ...{ card: 'friendship', project: null, checks: ['passed', 'open'], failed: count % 6, running: true },
  ...{ idle: count % 200, size: [200, 150], pose: { x: count % 200, y: 40, heading: 0 } },
  trail: Array.from({ length: 120 }, (_, step) => (count + step) % 200),
})

/** Starts the pupils' pages. @returns their answered requests since the last `take`, and how to stop */
export async function startChildren(url: string, of: OpenClass, pupils: number) {
  let answered: Answered[] = []
  const stop = new AbortController()
  const note = async (kind: Answered['kind'], act: () => ReturnType<Client['ask']>) => {
    const began = performance.now()
    const { status } = await act()
    answered.push({ kind, took: performance.now() - began, isRefused: status >= 400 })
    return status
  }

  async function play(child: Client, at: number) {
    let base = 0
    // Children do not save in the same moment.
    await wait((at / pupils) * every)
    await everyMs(every, stop.signal, async (count) => {
      // Index 0 has no picture: a project of 60 kB.
      const text = projectOfLesson(`save ${count}`, 0)
      const path = `/projects/project-worst-${at}?base=${base}&save=save-worst-${at}-${count}`
      if ((await note('save', () => child.ask('PUT', path, text))) === 200) base++
      await note('read', () => child.ask('PUT', '/me/here', reportOf(count)))
      await note('read', () => child.ask('GET', '/projects'))
    })
  }

  const children: Client[] = []
  for (let at = 0; at < pupils; at++) children.push(await joined(url, of, `Kind ${at}`))
  const ends = children.map((child) => child.listen('/me/stream'))
  const playing = children.map(play)
  return {
    take: () => {
      const taken = answered
      answered = []
      return taken
    },
    stop: async () => {
      stop.abort()
      ends.forEach((end) => end())
      await Promise.all(playing)
    },
  }
}
