import { setTimeout as wait } from 'node:timers/promises'
import { Client } from '@botgarten/server/rehearsal'

/** A class that can be joined. */
export interface OpenClass {
  readonly id: string
  readonly code: string
}

/** Makes the first teacher of a server. @param token secret of the link for it */
export async function firstTeacher(url: string, token: string): Promise<Client> {
  const teacher = new Client(url)
  await teacher.untilDone('POST', '/teachers', { token, username: 'worst', password: token })
  return teacher
}

export async function openClass(teacher: Client, name: string): Promise<OpenClass> {
  const endsOn = `${new Date().getFullYear() + 1}-07-31`
  const made = { name, language: 'en', grade: 5, endsOn }
  const { id } = await teacher.untilDone<{ id: string }>('POST', '/classes', made)
  await teacher.untilDone('POST', `/classes/${id}/open`)
  const { words } = await teacher.untilDone<{ words: string[] }>('GET', `/classes/${id}`)
  return { id, code: words.join(' ') }
}

/** A pupil on a device of its own. */
export async function joined(url: string, { code }: OpenClass, nickname: string): Promise<Client> {
  const pupil = new Client(url)
  await pupil.untilDone('POST', '/join', { code, nickname })
  return pupil
}

/** Repeats something until the signal. @param pause ms from one beginning to the next */
export async function everyMs(pause: number, signal: AbortSignal, act: (count: number) => Promise<unknown>) {
  for (let count = 0; !signal.aborted; count++) {
    const began = performance.now()
    await act(count).catch(() => null)
    const left = pause - (performance.now() - began)
    await wait(Math.max(0, left), undefined, { signal }).catch(() => null)
  }
}
