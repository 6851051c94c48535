import { isLong } from '@botgarten/numbers/testing'
import fc from 'fast-check'
import { expect, test } from 'vitest'
import { onBothDatabases } from './testing/databases.ts'
import type { Browser } from './testing/browser.ts'
import { projectText } from './testing/projects.ts'
import { quickAccounts, Server } from './testing/world.ts'

const runs = isLong ? 500 : 25

interface Scene {
  readonly id: string
  readonly teacher: Browser
  readonly pupils: readonly { readonly id: string; readonly browser: Browser }[]
}
type Act = (scene: Scene, child: number) => Promise<{ readonly status: number }>

const ofClass =
  (method: string, path: string, body?: unknown): Act =>
  ({ id, teacher }) =>
    teacher.ask(method, `/classes/${id}${path}`, body)
const ofPupil =
  (method: string, path: string, body?: unknown): Act =>
  ({ id, teacher, pupils }, child) =>
    teacher.ask(method, `/classes/${id}/pupils/${pupils[child]!.id}${path}`, body)
const byPupil =
  (method: string, path: string, body?: unknown): Act =>
  ({ pupils }, child) =>
    pupils[child]!.browser.ask(method, path, body)

/** What a class reads of itself. */
const reading: readonly Act[] = [
  ...['/results', '/results.csv', '/live', '/data', '/export', '/pupils', ''].map((path) =>
    ofClass('GET', path),
  ),
  ...['/projects', '/everything'].map((path) => ofPupil('GET', path)),
  ...['/questionnaires', '/questionnaires/results'].map((path) => ofClass('GET', path)),
  ofPupil('POST', '/inside'),
  ...['/me', '/me/questionnaire', '/projects', '/projects/project-1', '/projects/project-1/versions'].map(
    (path) => byPupil('GET', path),
  ),
]

/** What changes or deletes under their hands. */
const changing: readonly Act[] = [
  byPupil('PUT', '/projects/project-1?base=1&save=save-0002', projectText('b')),
  byPupil('PUT', '/projects/project-1?base=1&save=save-0003', projectText('c')),
  byPupil('PUT', '/projects/project-2?base=0&save=save-0004', projectText('d')),
  byPupil('DELETE', '/projects/project-1?base=1'),
  byPupil('PUT', '/me/hand', { up: true }),
  byPupil('POST', '/me/leave'),
  ofPupil('PATCH', '', { nickname: 'Otter' }),
  ofPupil('POST', '/pictures'),
  ofPupil('DELETE', ''),
  ofClass('POST', '/handouts', { to: 'all', kind: 'hint', card: 'friendship', hint: 1 }),
  ofClass('POST', '/questionnaires', { form: 'after' }),
  ofClass('POST', '/questionnaires/after/close'),
  ofClass('POST', '/code'),
  ofClass('POST', '/sign-out-all'),
  ofClass('POST', '/close'),
  ofClass('DELETE', '', { name: '5b' }),
]

const step = fc.record({ act: fc.constantFrom(...reading, ...changing), child: fc.nat(2) })

onBothDatabases((fresh) => {
  test(
    'whatever is read while a class saves, is changed or deleted is never our fault',
    { timeout: 600_000 },
    async () => {
      const database = await fresh()
      const server = new Server(database, quickAccounts(database))
      const teacher = await server.firstTeacher()

      async function scene(): Promise<Scene> {
        const { id, code } = await server.openClass(teacher)
        const pupils = []
        for (const name of ['Fuchs', 'Dachs', 'Luchs']) pupils.push(await server.pupil(code, name))
        for (const { browser } of pupils)
          await browser.put('/projects/project-1?base=0&save=save-0001', projectText('a'))
        return { id, teacher, pupils }
      }

      await fc.assert(
        fc.asyncProperty(fc.array(step, { minLength: 6, maxLength: 20 }), async (steps) => {
          const all = await scene()
          const answers = await Promise.all(steps.map(({ act, child }) => act(all, child)))
          expect(answers.map(({ status }) => status)).not.toContain(500)
        }),
        { numRuns: runs },
      )
      expect(server.logged.filter(({ status }) => status === 500)).toEqual([])
    },
  )
})
