import { once } from 'node:events'
import type { RequestListener } from 'node:http'
import { createServer, type Server } from 'node:https'
import type { AddressInfo } from 'node:net'
import { networkInterfaces } from 'node:os'
import { privateAddresses } from '../addresses.ts'
import { timeAtLeast } from '../doctor/old-files.ts'
import { certificatesIn, type Certificates } from './key-folder.ts'

export interface SecureServer {
  readonly server: Server
  readonly port: number
  /** The certificate that devices are to trust, as PEM. */
  authority(): string
  /** Stops to look for new addresses. */
  stop(): void
}

/** A hot spot gives another address, and a laptop moves from room to room: looked for so often, ms. */
const every = 60_000

/** The authority goes along, for a device that knows its key alone. */
const chainOf = ({ certificate, authority, key }: Certificates) => ({ cert: certificate + authority, key })

const names = () => ['botgarten.local', ...privateAddresses(networkInterfaces())]

/**
 * Answers https by an authority of the data folder's own.
 * @throws the error of `listen`, with its `code`
 */
export async function startSecure(
  data: string,
  listener: RequestListener,
  port: number,
  host?: string,
): Promise<SecureServer> {
  // A certificate of 1970 would be worth nothing on devices whose clocks are right.
  const made = () => certificatesIn(data, names(), timeAtLeast(data, Date.now()))
  let now = await made()
  const server = createServer(chainOf(now), listener)
  server.listen({ port, host })
  await once(server, 'listening')

  async function look() {
    const next = await made()
    if (next.certificate === now.certificate) return
    now = next
    server.setSecureContext(chainOf(next))
  }
  // A full disk may not end the server: the certificate that it has goes on.
  const timer = setInterval(() => void look().catch(() => {}), every)
  timer.unref()
  return {
    server,
    port: (server.address() as AddressInfo).port,
    authority: () => now.authority,
    stop: () => clearInterval(timer),
  }
}
