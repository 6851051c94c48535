import { isIP } from 'node:net'
import type { NetworkInterfaceInfo } from 'node:os'
import { isPrivate } from './https/constraints.ts'

type Interfaces = { readonly [name: string]: readonly NetworkInterfaceInfo[] | undefined }

/** Of which a server that listens at one address alone is reached under none but that one. @param host none: all */
export function listenedAt(interfaces: Interfaces, host?: string): Interfaces {
  if (host === undefined || isIP(host) === 0 || host === '0.0.0.0' || host === '::') return interfaces
  return Object.fromEntries(
    Object.entries(interfaces).map(([name, list = []]) => [
      name,
      list.filter(({ address }) => address === host),
    ]),
  )
}

/** This machine's addresses in private networks: those that an authority of a classroom may vouch for. */
export const privateAddresses = (interfaces: Interfaces): string[] =>
  Object.values(interfaces)
    .flatMap((list) => list ?? [])
    .map(({ address }) => address)
    .filter(isPrivate)

/** Where devices that trust the server's authority reach it. */
export const secureAddresses = (port: number, interfaces: Interfaces): string[] =>
  privateAddresses(interfaces).map((host) => `https://${host}:${port}`)

/**
 * Where a server on all addresses can be reached, this machine's own name first.
 * Link-local IPv6 (fe80::) is left out: browsers take no zone in an address.
 */
export function addresses(port: number, interfaces: Interfaces): string[] {
  const others = Object.values(interfaces)
    .flatMap((list) => list ?? [])
    .filter(({ internal, address }) => !internal && !address.toLowerCase().startsWith('fe80:'))
    .map(({ family, address }) => (family === 'IPv6' ? `[${address}]` : address))
  return ['localhost', ...others].map((host) => `http://${host}:${port}`)
}
