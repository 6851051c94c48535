import type { IncomingMessage, ServerResponse } from 'node:http'

/** What only the machine that serves is told. */
export interface Here {
  /** How it is reached, its own name first. */
  readonly addresses: readonly string[]
  /** The one that other devices are told; null: there is none. */
  readonly announced: string | null
  /** Where all that is saved lies; null: nothing is. */
  readonly folder: string | null
  /** When another device last reached it, ms since 1970; null: none has. */
  readonly otherDevice: number | null
}

const ownAddress = /^(::1|(::ffff:)?127(\.\d+){3})$/
const ownName = /^(localhost|127(\.\d+){3}|\[::1\])(:\d+)?$/

/**
 * Does a page of this machine ask? Under another name it may be a page of somebody else whose address leads here, and
 * behind a proxy everybody seems to be this machine.
 */
export const isHere = ({ headers, socket }: Pick<IncomingMessage, 'headers' | 'socket'>): boolean =>
  ownAddress.test(socket.remoteAddress ?? '') &&
  ownName.test(headers.host ?? '') &&
  headers['x-forwarded-for'] === undefined &&
  headers['forwarded'] === undefined

/** How the server is reached and where it keeps things; nothing for who asks from elsewhere. */
export function answerHere(request: IncomingMessage, response: ServerResponse, here: () => Here): void {
  if (!isHere(request)) return void response.writeHead(204).end()
  response.setHeader('content-type', 'application/json').end(JSON.stringify(here()))
}
