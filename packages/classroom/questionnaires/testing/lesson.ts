import type { Chance } from '@botgarten/answers'
import { blindInput } from '@botgarten/answers/tokens'
import type { Browser } from '../../testing/browser.ts'
import { projectText } from '../../testing/projects.ts'
import type { Server } from '../../testing/world.ts'
import { answerOf } from './children.ts'
import { permitOf, type Permit } from './devices.ts'

/** What is known of a lesson afterwards. */
export interface Lesson {
  readonly class: string
  /** With which it can be joined. */
  readonly code: string
  /** Of every pupil, in the order in which they saved last before their answers. */
  readonly pupils: readonly { readonly id: string; readonly nickname: string; readonly answer: string }[]
  /** Ids of the answers in the order in which they came. */
  readonly came: readonly string[]
  readonly key: string
}

const seconds = 1000

/**
 * A class of which every pupil saves, opens the form, and saves again; answers are sent up to two minutes later by chance.
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
    const saves = child * 25 * seconds
    pupils.push({
      ...joined,
      nickname,
      saves,
      sends: saves + Math.floor(chance() * 120 * seconds),
    })
  }
  const random = (bytes: number) => Uint8Array.from({ length: bytes }, () => Math.floor(chance() * 256))
  const permits = new Map<string, Permit>()
  const opens = async (pupil: string, browser: Browser) =>
    void permits.set(pupil, await permitOf(browser, blindInput(random)))
  const begun = server.now
  const events = pupils.flatMap((pupil, child) => [
    {
      at: pupil.saves,
      act: () =>
        save(pupil.browser, 0)
          .then(() => opens(pupil.id, pupil.browser))
          .then(() => choose(server, permits.get(pupil.id)!, form, child)),
    },
    { at: pupil.saves + 20 * seconds, act: () => save(pupil.browser, 1) },
    { at: pupil.sends, act: () => send(server, permits.get(pupil.id)!, form, child) },
  ])
  for (const { at, act } of events.toSorted((a, b) => a.at - b.at)) {
    server.passes(begun + at - server.now)
    await act()
  }
  const answered = pupils.map((pupil) => ({ ...pupil, answer: permits.get(pupil.id)!.id }))
  const came = answered.toSorted((a, b) => a.sends - b.sends).map(({ answer }) => answer)
  return { class: id, code, pupils: answered, came, key: permits.get(pupils[0]!.id)!.key }
}

const save = (browser: Browser, base: number) =>
  browser.put(`/projects/project-1?base=${base}&save=save-000${base}`, projectText('Garten'))

/** A device chooses its code as soon as the form is open. */
async function choose(server: Server, permit: Permit, form: string, child: number) {
  const { code } = answerOf(form, child)
  const { status } = await server.browser(`192.168.1.${child}`).post('/answers/code', { ...permit, code })
  if (status !== 200) throw new Error(`The code was refused: ${status}`)
}

async function send(server: Server, permit: Permit, form: string, child: number) {
  const { status } = await server
    .browser(`192.168.1.${child}`)
    .post('/answers', { ...permit, ...answerOf(form, child) })
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
