import { beforeAll, beforeEach, expect, test } from 'vitest'
import { onBothDatabases } from '../testing/databases.ts'
import type { Browser } from '../testing/browser.ts'
import { quickAccounts, Server } from '../testing/world.ts'

const hall = { name: 'Aula "Süd"; 2', password: 'sonne:mond\\sterne' }

onBothDatabases((fresh) => {
  let server: Server
  let operator: Browser
  let teacher: Browser
  let path: string

  beforeAll(async () => {
    const database = await fresh()
    server = new Server(database, quickAccounts(database))
    operator = await server.firstTeacher()
    teacher = await server.furtherTeacher(operator)
    path = `/classes/${(await server.openClass(teacher)).id}/wifi`
  })
  beforeEach(() => teacher.delete(path))

  test('a class has no Wi-Fi until its teacher names one; it can be changed and removed', async () => {
    expect((await teacher.get(path)).body).toEqual({ wifi: null })
    expect((await teacher.put(path, hall)).status).toBe(204)
    expect((await teacher.get(path)).body).toEqual({ wifi: hall })
    const open = { name: 'Gäste', password: '' }
    await teacher.put(path, open)
    expect((await teacher.get(path)).body).toEqual({ wifi: open })
    expect((await teacher.delete(path)).status).toBe(204)
    expect((await teacher.get(path)).body).toEqual({ wifi: null })
  })

  test('it is that of all classes of the teacher, and of nobody else', async () => {
    await teacher.put(path, hall)
    const { id } = await server.openClass(teacher, '6a')
    expect((await teacher.get(`/classes/${id}/wifi`)).body).toEqual({ wifi: hall })
    const theirs = await server.openClass(operator)
    expect((await operator.get(`/classes/${theirs.id}/wifi`)).body).toEqual({ wifi: null })
    expect((await operator.get(path)).status).toBe(404)
  })

  test('a machine that makes a Wi-Fi shows it where the teacher has named none', async () => {
    const { host } = server.ports
    const own = { name: 'Botgarten', password: 'abcd-efgh-jkmn' }
    Object.assign(server.ports, { host: { ...host, wifi: own } })
    expect((await teacher.get(path)).body).toEqual({ wifi: own })
    await teacher.put(path, hall)
    expect((await teacher.get(path)).body).toEqual({ wifi: hall })
    Object.assign(server.ports, { host })
  })

  test('a substitute shows it on the wall and changes nothing of it', async () => {
    await teacher.put(path, hall)
    const { token } = (await teacher.post(path.replace('wifi', 'substitute'))).body as { token: string }
    const substitute = server.browser()
    await substitute.post('/substitute', { token })
    expect((await substitute.get(path)).body).toEqual({ wifi: hall })
    expect((await substitute.put(path, { name: 'x', password: '' })).status).toBe(401)
    expect((await substitute.delete(path)).status).toBe(401)
  })

  test.each([
    { name: '', password: '' },
    { name: ' ', password: '' },
    { name: 'ä'.repeat(17), password: '' },
    { name: 'a\nb', password: '' },
    { name: 'Aula', password: '1234567' },
    { name: 'Aula', password: 'x'.repeat(64) },
    { name: 'Aula', password: 'größer als acht' },
    { name: 'Aula' },
  ])('what no Wi-Fi can be called or open with is refused: %j', async (wifi) => {
    expect((await teacher.put(path, wifi)).status).toBe(400)
  })
})
