import { migrate, openSqlite } from '@botgarten/classroom'
import { quickAccounts, Server } from '@botgarten/classroom/testing'
import { ClassApi } from '../model/api.ts'

const host = 'http://lab.test'

/** A new class server, in this process. */
export async function freshServer(): Promise<Server> {
  const database = openSqlite(':memory:')
  await migrate(database)
  return new Server(database, quickAccounts(database))
}

type Ask = (path: string, init: RequestInit) => Promise<Response>

/** Asks as a browser on its page does, and keeps its cookies. */
export function askerOn(server: Server): Ask {
  const cookies = new Map<string, string>()
  return async (path, init) => {
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
  }
}

export const apiOn = (server: Server): ClassApi => new ClassApi(askerOn(server))
