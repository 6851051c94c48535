import fc from 'fast-check'
import { beforeAll, expect, test } from 'vitest'
import { onBothDatabases } from '../testing/databases.ts'
import type { Browser } from '../testing/browser.ts'
import { projectText } from '../testing/projects.ts'
import { quickAccounts, Server } from '../testing/world.ts'

interface Ancestor {
  readonly id: string
  readonly title: string | null
  readonly by: string | null
  readonly own: boolean
}
interface Looked {
  readonly title: string
  readonly chain: readonly Ancestor[]
  readonly project: { readonly madeFrom?: readonly { readonly id: string; readonly title: string }[] }
}

const nicknames = ['Fuchs', 'Eule', 'Igel']

/** A step in the life of a gallery: `by` remixes the n-th thing that was ever shared, or it goes in one of three ways. */
const step = fc.oneof(
  { weight: 4, arbitrary: fc.record({ do: fc.constant('remix' as const), by: fc.nat(2), of: fc.nat(9) }) },
  fc.record({ do: fc.constantFrom('takeBack' as const, 'hide' as const), by: fc.nat(2), of: fc.nat(9) }),
  { weight: 1, arbitrary: fc.record({ do: fc.constant('leave' as const), by: fc.nat(2), of: fc.nat(9) }) },
)

onBothDatabases((fresh) => {
  let server: Server
  let teacher: Browser

  beforeAll(async () => {
    const database = await fresh()
    server = new Server(database, quickAccounts(database))
    teacher = await server.firstTeacher()
  })

  test('a chain stays as long as it was, names who is there, and says "somebody" for the rest', async () => {
    await fc.assert(
      fc.asyncProperty(fc.array(step, { minLength: 3, maxLength: 14 }), async (steps) => {
        const opened = await server.openClass(teacher)
        const reader = await server.pupil(opened.code, 'Leser')
        const pupils = []
        for (const name of nicknames) pupils.push(await server.pupil(opened.code, name))
        /** What must be true, kept in the plainest way: all that was ever shared, with its whole line. */
        const made: { id: string; by: number; title: string; line: string[]; out: boolean }[] = []
        const gone = new Set<number>()

        for (const [at, { do: what, by, of }] of steps.entries()) {
          const parent = made.filter(({ out }) => !out)[of]
          if (what === 'remix' && !gone.has(by)) {
            const line = parent ? [...parent.line, parent.id] : []
            const found = parent && ((await pupils[by]!.browser.get(`/gallery/${parent.id}`)).body as Looked)
            const before = found
              ? [...(found.project.madeFrom ?? []), { id: parent.id, title: found.title }]
              : []
            const project = { ...(JSON.parse(projectText(`${at}`)) as object), madeFrom: before }
            const { body } = await pupils[by]!.browser.post(`/gallery?share=share-${at + 100_000}`, project)
            made.push({ id: (body as { id: string }).id, by, title: `Garden ${at}`, line, out: false })
          } else if (what === 'leave' && !gone.has(by)) {
            await teacher.delete(`/classes/${opened.id}/pupils/${pupils[by]!.id}`)
            gone.add(by)
            for (const one of made) if (one.by === by) one.out = true
          } else if (parent && what === 'takeBack') {
            await pupils[parent.by]!.browser.delete(`/gallery/${parent.id}`)
            parent.out = true
          } else if (parent && what === 'hide') {
            await teacher.put(`/classes/${opened.id}/gallery/${parent.id}`, { hidden: true })
            parent.out = true
          }
        }

        for (const { id, line } of made.filter(({ out }) => !out)) {
          const { chain, project } = (await reader.browser.get(`/gallery/${id}`)).body as Looked
          const expected = line.map((ancestor) => {
            const one = made.find((other) => other.id === ancestor && !other.out)
            return {
              id: ancestor,
              title: one?.title ?? null,
              by: one ? nicknames[one.by]! : null,
              own: false,
            }
          })
          expect(chain).toEqual(expected)
          // What leaves the class has titles and no names.
          const titles = expected.map(({ id: of, title }) => ({ id: of, title: title ?? '' }))
          expect(project.madeFrom ?? []).toEqual(titles)
          for (const name of nicknames) expect(JSON.stringify(project)).not.toContain(name)
        }
      }),
      { numRuns: 25 },
    )
  }, 120_000)

  test('in a chain the own work is marked, for its child alone', async () => {
    const { id, code } = await server.openClass(teacher)
    const [fox, owl] = [await server.pupil(code, 'Fuchs'), await server.pupil(code, 'Eule')]
    const share = async (by: Browser, share: string, madeFrom: readonly object[]) => {
      const project = { ...(JSON.parse(projectText(share)) as object), madeFrom }
      return ((await by.post(`/gallery?share=${share}`, project)).body as { id: string }).id
    }
    const first = await share(fox.browser, 'share-0001', [])
    const second = await share(owl.browser, 'share-0002', [{ id: first, title: 'x' }])
    const isOwn = async (reader: Browser, path: string) =>
      ((await reader.get(path)).body as Looked).chain.map(({ own }) => own)
    expect(await isOwn(fox.browser, `/gallery/${second}`)).toEqual([true])
    expect(await isOwn(owl.browser, `/gallery/${second}`)).toEqual([false])
    expect(await isOwn(teacher, `/classes/${id}/gallery/${second}`)).toEqual([false])
  })

  test('a chain that was made up names nobody of another class and is not endless', async () => {
    const [here, there] = [await server.openClass(teacher), await server.openClass(teacher, '6a')]
    const [child, stranger] = [await server.pupil(here.code, 'Fuchs'), await server.pupil(there.code, 'Eule')]
    const { body } = await stranger.browser.post('/gallery?share=share-0001', projectText('theirs'))
    const theirs = { id: (body as { id: string }).id, title: 'x' }
    const many = Array.from({ length: 99 }, (_, at) => ({ id: `forged-${at}`, title: 'y' }))
    const project = { ...(JSON.parse(projectText('mine')) as object), madeFrom: [...many, theirs] }
    const { body: made } = await child.browser.post('/gallery?share=share-0002', project)
    const { body: seen } = await child.browser.get(`/gallery/${(made as { id: string }).id}`)
    const { chain } = seen as Looked
    expect(chain).toHaveLength(20)
    expect(chain.every(({ title, by }) => title === null && by === null)).toBe(true)
  })
})
