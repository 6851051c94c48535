import fc from 'fast-check'
import { isLong } from '@botgarten/numbers/testing'
import { expect, test } from 'vitest'
import { routes } from './routes.ts'
import { onBothDatabases } from './testing/databases.ts'
import { projectText } from './testing/projects.ts'
import { Server } from './testing/world.ts'
import { pictures } from './joining/pictures.ts'

const runs = isLong ? 5000 : 200

const text = fc.oneof(
  fc.constantFrom(
    '',
    'project-1',
    '5b',
    '__proto__',
    '../..',
    '%00',
    '\0',
    '\ud800',
    "'; drop table pupil",
    'kite otter plum',
  ),
  fc.string({ unit: 'binary', maxLength: 40 }),
)
const entry = fc.oneof(
  text,
  fc.integer(),
  fc.double(),
  fc.boolean(),
  fc.constant(null),
  fc.array(fc.constantFrom(...pictures), { minLength: 2, maxLength: 4 }),
  fc.constantFrom('2027-01-31', '2026-11-24', 'de', 'en'),
)
const names = [
  'code',
  'nickname',
  'pictures',
  'token',
  'username',
  'password',
  'newPassword',
  'name',
  'language',
  'grade',
  'endsOn',
  'up',
  'on',
  'hidden',
  'card',
  'to',
]
const body = fc.oneof(
  fc.dictionary(fc.constantFrom(...names), entry),
  fc.jsonValue(),
  fc.constantFrom('{', '[', projectText('r'), '{"a":"\\u0000"}'),
)
const query = fc.oneof(
  fc.constantFrom(
    '',
    '?base=0&save=save-0001',
    '?base=1&save=save-0002',
    '?base=-1&save=x',
    '?base=1e9&save=save-0003',
    '?share=share-0001',
    '?by=hearts&from=0',
    '?card=friendship',
  ),
  fc.webQueryParameters().map((parameters) => `?${parameters}`),
)

onBothDatabases((fresh) => {
  test(`any ${runs} requests, by whomever, are never our fault`, { timeout: 1_200_000 }, async () => {
    const server = new Server(await fresh())
    const teacher = await server.firstTeacher()
    const { id, code } = await server.openClass(teacher)
    const child = await server.pupil(code, 'Fuchs')
    const senders = [teacher, child.browser, server.browser()]
    const parts = fc.oneof(fc.constantFrom(id, child.id, 'project-1', '1'), fc.webSegment())
    const request = fc.record({
      route: fc.constantFrom(...routes),
      method: fc.constantFrom('GET', 'POST', 'PUT', 'PATCH', 'DELETE', 'route', 'route', 'route', 'route'),
      ...{ parts: fc.array(parts, { minLength: 3, maxLength: 3 }), query, body },
      sender: fc.nat(2),
      minutes: fc.constantFrom(0, 0, 0, 1, 30),
    })
    const statuses = new Set<number>()
    await fc.assert(
      fc.asyncProperty(request, async ({ route, method, parts, query, body, sender, minutes }) => {
        let part = 0
        const path = route.path.replaceAll(/:\w+/g, () => parts[part++]!)
        const by = method === 'route' ? route.method : method
        server.later(minutes)
        const answer = await senders[sender]!.ask(by, path + query, by === 'GET' ? undefined : body)
        statuses.add(answer.status)
        expect(answer.status, `${by} ${path}`).not.toBe(500)
      }),
      { numRuns: runs },
    )
    // It got through the doors: not all of them were refused at the first one.
    for (const status of [200, 400, 401, 404]) expect(statuses).toContain(status)
    expect(server.logged.filter((line) => line.status === 500)).toEqual([])
  })
})
