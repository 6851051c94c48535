// Makes the data folder of a small class, as a class server of this commit writes it, with a nightly backup in it:
// `npm run samples -- FOLDER`. Tests of later versions open it. `known.json` holds the secrets of its pupils.
import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { backup, handle, phraseOf } from '../../packages/classroom/index.ts'
import { openClassServer } from '../../packages/server/index.ts'

const data = process.argv[2]
if (data === undefined) throw new Error('The folder is missing.')
const classServer = await openClassServer({ data })
const url = 'http://localhost:4173'
const caller = { address: '127.0.0.1', secure: false, reached: '127.0.0.1' }

/** A browser with its cookies. */
function asker() {
  const jar = new Map<string, string>()
  const ask = async (method: string, path: string, body?: unknown): Promise<unknown> => {
    const headers = new Headers({ origin: url, host: 'localhost:4173' })
    headers.set('cookie', [...jar].map(([name, value]) => `${name}=${value}`).join('; '))
    const text = body === undefined ? null : typeof body === 'string' ? body : JSON.stringify(body)
    if (text !== null) headers.set('content-type', 'application/json')
    const request = new Request(`${url}/api/class${path}`, { method, headers, body: text })
    const answer = await handle(request, classServer.ports, caller)
    if (!answer.ok) throw new Error(`${method} ${path}: ${answer.status} ${await answer.text()}`)
    for (const line of answer.headers.getSetCookie()) {
      const [, name = '', value = ''] = /^([^=]+)=([^;]*)/.exec(line) ?? []
      jar.set(name, value)
    }
    return answer.status === 204 ? null : answer.json()
  }
  return { ask, cookies: () => Object.fromEntries(jar) }
}

const bo = {
  ...{ id: 'bo', pose: { x: 50, y: 50, heading: 0 }, program: 'main', brain: '' },
  config: { wheelDiameter: 5.6, trackWidth: 11, sensors: {}, drive: { left: 'B', right: 'C' } },
}
const garden = (name: string) => ({
  ...{ botgarten: 1, name, card: 'friendship', brains: {}, assets: {} },
  programs: { main: { stacks: [], config: { stacks: [] } } },
  world: {
    ...{ size: { width: 200, height: 150 }, floor: { colour: '#ffffff' } },
    ...{ areas: [], lines: [], obstacles: [], robots: [bo] },
  },
})

const teacher = asker()
const token = await classServer.firstTeacher()
await teacher.ask('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
const about = { name: '5b', language: 'en', grade: 5, endsOn: classServer.ports.day(120) }
const { id } = (await teacher.ask('POST', '/classes', about)) as { id: string }
await teacher.ask('POST', `/classes/${id}/open`)
const { code } = (await teacher.ask('GET', `/classes/${id}`)) as { code: string }
const pupils = []
let back = () => Promise.resolve<unknown>(null)
for (const nickname of ['Fuchs', 'Eule']) {
  const { ask, cookies } = asker()
  const joined = (await ask('POST', '/join', { code, nickname })) as { id: string; pictures: string[] }
  for (const base of [0, 1])
    await ask(
      'PUT',
      `/projects/project-friendship?base=${base}&save=save-${nickname}-${base}`,
      garden(`Work ${base + 1}`),
    )
  await ask('PUT', `/projects/project-fear?base=0&save=save-${nickname}-fear`, garden('Fear'))
  await ask('DELETE', '/projects/project-fear?base=1')
  // The lesson ends: one of the two shows the pictures in the next one.
  await teacher.ask('POST', `/classes/${id}/close`)
  await teacher.ask('POST', `/classes/${id}/open`)
  const isBack = nickname === 'Fuchs'
  if (isBack) back = () => ask('POST', '/me/pictures', { pictures: joined.pictures })
  pupils.push({ isBack, nickname, id: joined.id, pictures: joined.pictures, cookies: cookies() })
}
await back()
mkdirSync(join(data, 'backups'), { recursive: true })
const { database, secret } = classServer.ports
const day = classServer.ports.day(0)
await backup({ database, secret, folder: data, day }, join(data, 'backups', `000001-${day}.age`))
const phrase = await phraseOf(database, secret)
const known = { madeAt: Date.now(), class: id, code, phrase, pupils, teacher: { cookies: teacher.cookies() } }
writeFileSync(join(data, 'known.json'), `${JSON.stringify(known, null, 2)}\n`)
await classServer.close()
