import type { Chance } from '@botgarten/answers'
import type { Browser } from '../../testing/browser.ts'
import { projectText } from '../../testing/projects.ts'
import type { Server } from '../../testing/world.ts'
import { answerOf } from './children.ts'

/** What is known of a lesson afterwards. */
export interface Lesson {
  readonly class: string
  /** Of every pupil, in the order in which they saved last before their answers. */
  readonly pupils: readonly { readonly id: string; readonly nickname: string; readonly answer: string }[]
  /** Ids of the answers in the order in which they came. */
  readonly came: readonly string[]
  readonly key: string
}

const seconds = 1000

/**
 * A class of which every pupil saves, answers, and saves again; answers are sent up to two minutes later by chance.
 * @param chance the same in every run
 */
export async function playLesson(
  server: Server,
  teacher: Browser,
  form: string,
  { pupils: count, chance }: { readonly pupils: number; readonly chance: Chance },
): Promise<Lesson> {
  const { id, code } = await server.openClass(teacher)
  await teacher.post(`/classes/${id}/questionnaires`, { form })
  const pupils = []
  for (let child = 0; child < count; child++) {
    const nickname = `Kind ${child}`
    const joined = await server.pupil(code, nickname)
    const digits = Array.from({ length: 32 }, () => Math.floor(chance() * 16).toString(16)).join('')
    const saves = child * 25 * seconds
    pupils.push({
      ...joined,
      nickname,
      answer: digits,
      saves,
      sends: saves + Math.floor(chance() * 120 * seconds),
    })
  }
  const { body } = await pupils[0]!.browser.get('/me/questionnaire')
  const { key } = body as { key: string }
  const begun = server.now
  const events = pupils.flatMap((pupil, child) => [
    { at: pupil.saves, act: () => save(pupil.browser, 0) },
    { at: pupil.saves + 20 * seconds, act: () => save(pupil.browser, 1) },
    { at: pupil.sends, act: () => send(server, key, pupil.answer, form, child) },
  ])
  for (const { at, act } of events.toSorted((a, b) => a.at - b.at)) {
    server.now = begun + at
    await act()
  }
  const came = pupils.toSorted((a, b) => a.sends - b.sends).map(({ answer }) => answer)
  return { class: id, pupils, came, key }
}

const save = (browser: Browser, base: number) =>
  browser.put(`/projects/project-1?base=${base}&save=save-000${base}`, projectText('Garten'))

async function send(server: Server, key: string, id: string, form: string, child: number) {
  const { status } = await server.browser().post('/answers', { key, ...answerOf(form, child), id })
  if (status !== 204) throw new Error(`The answer was refused: ${status}`)
}

/** The form is closed, and what was on its way has had its time. */
export async function endLesson(server: Server, teacher: Browser, { class: id }: Lesson, form: string) {
  const closed = await teacher.post(`/classes/${id}/questionnaires/${form}/close`)
  server.later(2)
  const { status } = await teacher.get(`/classes/${id}/questionnaires`)
  if (closed.status !== 204 || status !== 200) throw new Error(`It is not closed: ${status}`)
}

/** Spearman's rank correlation of two orders of the same things: 1 the same, 0 nothing in common, -1 reversed. */
export function agreement(one: readonly string[], other: readonly string[]): number {
  const at = new Map(other.map((name, index) => [name, index]))
  const n = one.length
  const sum = one.reduce((total, name, index) => total + (index - at.get(name)!) * (index - at.get(name)!), 0)
  return 1 - (6 * sum) / (n * (n * n - 1))
}
