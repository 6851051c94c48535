// What x509 stands on asks for it before it is loaded.
import 'reflect-metadata'
import * as x509 from '@peculiar/x509'
import { isIP } from 'node:net'
import { nameConstraints } from './constraints.ts'

const day = 86_400_000
const algorithm = { name: 'ECDSA', namedCurve: 'P-256', hash: 'SHA-256' }
const usages = ['sign', 'verify'] as const

/** A certificate and its key, as PEM. */
export interface Pair {
  readonly certificate: string
  readonly key: string
}

const newKeys = () => crypto.subtle.generateKey(algorithm, true, [...usages])

/** Positive and of 16 bytes, as browsers ask for. */
const newSerial = () =>
  `4${Buffer.from(crypto.getRandomValues(new Uint8Array(16)))
    .toString('hex')
    .slice(1)}`

async function pemOfKey({ privateKey }: Awaited<ReturnType<typeof newKeys>>): Promise<string> {
  return x509.PemConverter.encode(await crypto.subtle.exportKey('pkcs8', privateKey), 'PRIVATE KEY')
}

/** Clocks in a classroom differ: what begins now is not valid yet on some devices. */
const lasting = (now: number, days: number) => ({
  notBefore: new Date(now - day),
  notAfter: new Date(now + days * day),
})

/**
 * An authority that vouches for a classroom's server and nothing else: two years, no authority below it.
 * @param now ms since 1970
 */
export async function newAuthority(now: number): Promise<Pair> {
  const keys = await newKeys()
  const certificate = await x509.X509CertificateGenerator.createSelfSigned({
    serialNumber: newSerial(),
    name: `CN=Botgarten ${new Date(now).toISOString().slice(0, 10)}`,
    ...lasting(now, 730),
    signingAlgorithm: algorithm,
    keys,
    extensions: [
      new x509.BasicConstraintsExtension(true, 0, true),
      new x509.KeyUsagesExtension(x509.KeyUsageFlags.keyCertSign | x509.KeyUsageFlags.cRLSign, true),
      new x509.Extension('2.5.29.30', true, nameConstraints),
      await x509.SubjectKeyIdentifierExtension.create(keys.publicKey),
    ],
  })
  return { certificate: `${certificate.toString('pem')}\n`, key: await pemOfKey(keys) }
}

/**
 * A server's certificate for 90 days.
 * @param names host names and IP addresses under which pages reach it
 */
export async function newLeaf(authority: Pair, names: readonly string[], now: number): Promise<Pair> {
  const issuer = new x509.X509Certificate(authority.certificate)
  const signingKey = await crypto.subtle.importKey(
    'pkcs8',
    x509.PemConverter.decodeFirst(authority.key),
    algorithm,
    false,
    ['sign'],
  )
  const keys = await newKeys()
  const certificate = await x509.X509CertificateGenerator.create({
    serialNumber: newSerial(),
    subject: `CN=Botgarten`,
    issuer: issuer.subject,
    ...lasting(now, 90),
    signingAlgorithm: algorithm,
    publicKey: keys.publicKey,
    signingKey,
    extensions: [
      new x509.BasicConstraintsExtension(false, undefined, true),
      new x509.KeyUsagesExtension(x509.KeyUsageFlags.digitalSignature, true),
      new x509.ExtendedKeyUsageExtension([x509.ExtendedKeyUsage.serverAuth]),
      new x509.SubjectAlternativeNameExtension(
        names.map((name) => ({ type: isIP(name) ? ('ip' as const) : ('dns' as const), value: name })),
      ),
      await x509.AuthorityKeyIdentifierExtension.create(issuer),
    ],
  })
  return { certificate: `${certificate.toString('pem')}\n`, key: await pemOfKey(keys) }
}
