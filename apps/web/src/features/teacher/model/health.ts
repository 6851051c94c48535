import { m } from '#words/message.ts'

/** One line of the server's health. */
export interface Fact {
  readonly id: string
  readonly fine: boolean
  readonly title: string
  readonly text: string
  readonly value: string
}

/** Only the machine of the server reaches it under these names. */
export const isOwnMachine = (hostname: string): boolean =>
  /^(localhost|127(\.\d+){3}|\[::1\])$/.test(hostname)

const address = ({ host, hostname }: Pick<Location, 'host' | 'hostname'>): Fact => ({
  id: 'address',
  fine: !isOwnMachine(hostname),
  title: m['teacher.address'](),
  text: isOwnMachine(hostname) ? m['teacher.addressOwn']() : m['teacher.addressText'](),
  value: host,
})

const offline = (secure: boolean): Fact => ({
  id: 'offline',
  fine: secure,
  title: m['teacher.offline'](),
  text: secure ? m['teacher.offlineText']() : m['teacher.offlineHttps'](),
  value: secure ? m['teacher.yes']() : m['teacher.notYet'](),
})

/** What a page knows of the server's health. */
export const healthOf = (at: Pick<Location, 'host' | 'hostname'>, secure: boolean): readonly Fact[] => [
  address(at),
  offline(secure),
]
