// A class as it is in the middle of a lesson, and pages of those who are in it.
import type { Page } from '@playwright/test'
import { classOfTest, pupilOf, type Asker } from './class-server.ts'
import { projectFile } from './projects.ts'

export type MadeClass = Awaited<ReturnType<typeof classOfTest>>
export type Joined = Awaited<ReturnType<MadeClass['pupil']>> & { readonly nickname: string }

/** The class holds projects under names that are longer than a device's. */
const inClass = (card: string) => `project-${card}`

/** A pupil who has just joined. */
export async function joins(made: MadeClass, nickname: string): Promise<Joined> {
  return { ...(await made.pupil(nickname)), nickname }
}

/** One more open class of the same teacher, 6a. */
export async function anotherClass(made: MadeClass): Promise<MadeClass> {
  const { teacher, url, classServer } = made
  const about = { name: '6a', language: 'en', grade: 6, endsOn: classServer.ports.day(120) }
  const { id } = (await teacher.ask('POST', '/classes', about)).body as { id: string }
  await teacher.ask('POST', `/classes/${id}/open`)
  const { words } = (await teacher.ask('GET', `/classes/${id}`)).body as { words: readonly string[] }
  const code = words.join(' ')
  return { ...made, id, code, pupil: (nickname) => pupilOf(url, code, nickname) }
}

/**
 * Saves a card in the class, as another device would.
 * @param base the revision it stands on; 0 for a new project
 * @param starts places from which it was solved
 */
export async function saves(
  { asker }: Pick<Joined, 'asker'>,
  { base = 0, starts = [0], program = 'solution' } = {},
) {
  const project = JSON.parse(projectFile('friendship', program)) as object
  const path = `/projects/${inClass('friendship')}?base=${base}&save=save-000${base + 1}`
  const { status, body } = await asker.ask('PUT', path, { ...project, progress: { starts, hints: 0 } })
  if (status >= 300) throw new Error(`A save was refused: ${status} ${JSON.stringify(body)}`)
}

/** A pupil's page in this browser: `asks` who sits there, shows that it is `back`, or is `here` at once. */
export async function signsIn(
  page: Page,
  made: MadeClass,
  { asker, id, nickname }: Joined,
  as: 'asks' | 'back' | 'here' = 'here',
) {
  await page.context().addCookies(asker.cookies)
  const owner = { pupil: id, class: made.id, nickname, className: '5b' }
  const here = { asks: null, back: `back ${id}`, here: id }[as]
  await page.addInitScript(
    ([owner, here]) => {
      // Once: what the page itself writes stays.
      if (sessionStorage.getItem('made') !== null) return
      sessionStorage.setItem('made', 'yes')
      localStorage.setItem('botgarten.class', JSON.stringify(owner))
      if (here !== null) sessionStorage.setItem('botgarten.here', here)
    },
    [owner, here] as const,
  )
}

/** The teacher's page in this browser. */
export const teaches = (page: Page, made: MadeClass) => page.context().addCookies(made.teacher.cookies)

const passed = { done: ['passed', 'passed', 'passed'], some: ['passed', 'failed', 'open'] } as const

/** What a page reports: a card, how far it is, and where Bo has driven. */
const report = (card: string, checks: readonly string[], more: object) => ({
  ...{ card, project: inClass(card), checks, failed: 0, running: true, idle: 0 },
  ...{ size: [600, 400], pose: { x: 366, y: 206, heading: 190 } },
  trail: Array.from({ length: 24 }, (_, at) => (at % 2 === 0 ? 500 - at * 6 : 262 - at * 2)),
  ...more,
})

const nicknames = [
  ...[
    'Ananas',
    'Biber 3',
    'Blitz',
    'Captain K',
    'Donut',
    'Eisbär',
    'Falke',
    'Gurke',
    'Hase 7',
    'Igel',
    'Jojo',
  ],
  ...['Kiwi', 'Luna', 'Mia 7', 'Nachteule im Garten', 'Noor', 'Otter', 'Pingu', 'Pixelpanda', 'Robofuchs'],
  ...['Sternchen', 'Tiger', 'Wolke', 'Zebra'],
]

export const works = async (asker: Asker, at: number) => {
  const card = ['friendship', 'fear', 'chameleon', 'rally'][at % 4]!
  const checks = at % 5 === 3 ? passed.done : passed.some
  await asker.ask('PUT', '/me/here', report(card, card === 'rally' ? checks.slice(1) : checks, {}))
}

/** Twenty-four pupils at work: one raises the hand, one fails at the same check, one changes nothing; one is not there. */
export async function fills(made: MadeClass, count = nicknames.length) {
  for (const [at, nickname] of nicknames.slice(0, count).entries()) {
    const pupil = await joins(made, nickname)
    const { asker } = pupil
    if (at % 3 !== 1) await saves(pupil, { starts: at % 2 === 0 ? [0, 1, 2] : [0] })
    if (nickname === 'Igel') continue
    await works(asker, at)
    if (nickname === 'Blitz') {
      await asker.ask('PUT', '/me/here', report('friendship', passed.some, { failed: 3 }))
      await asker.ask('PUT', '/me/hand', { up: true })
    }
    if (nickname === 'Pixelpanda')
      await asker.ask('PUT', '/me/here', report('friendship', passed.some, { failed: 6 }))
    if (nickname === 'Noor')
      await asker.ask('PUT', '/me/here', report('friendship', ['open', 'open', 'open'], { idle: 240 }))
  }
}
