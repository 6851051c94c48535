import { migrate, openSqlite } from '@botgarten/classroom'
import { Server } from '@botgarten/classroom/testing'
import { ClassApi } from '../model/api.ts'

const host = 'http://lab.test'

/** A class server that begins anew, in this process. */
export async function freshServer(): Promise<Server> {
  const database = openSqlite(':memory:')
  await migrate(database)
  return new Server(database)
}

/** A page's way to it, with cookies as its browser keeps them. */
export function apiOn(server: Server): ClassApi {
  const cookies = new Map<string, string>()
  return new ClassApi(async (path, init) => {
    const headers = new Headers(init.headers)
    headers.set('origin', host)
    headers.set('cookie', [...cookies].map(([name, value]) => `${name}=${value}`).join('; '))
    const answer = await server.ask(new Request(host + path, { ...init, headers }))
    for (const line of answer.headers.getSetCookie()) {
      const [, name, value] = /^([^=]+)=([^;]*)/.exec(line)!
      if (/Max-Age=0/i.test(line)) cookies.delete(name!)
      else cookies.set(name!, value!)
    }
    return answer
  })
}
