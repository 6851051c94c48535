import type * as v from 'valibot'
import type { Triers } from './joining/triers.ts'
import type { Caller, Ports } from './ports.ts'
import type { Role, Who } from './who.ts'

export type Method = 'GET' | 'POST' | 'PUT' | 'PATCH' | 'DELETE'

/** A request that was let through. */
export interface Call<Body> {
  readonly ports: Ports
  readonly who: Who
  /** What stands in the path in place of `:name`. */
  readonly at: { readonly [name: string]: string }
  readonly query: URLSearchParams
  readonly body: Body
  readonly headers: Headers
  readonly caller: Caller
  readonly triers: Triers
}

/** What a route answers: JSON, or a response of its own. */
export interface Answer {
  readonly status?: number
  readonly body?: unknown
  readonly cookies?: readonly string[]
}

/** A row of the table that the router follows: there is no other way to a handler. */
export interface Route {
  readonly method: Method
  /** Below `/api/class`, such as `/projects/:project`. */
  readonly path: string
  readonly roles: readonly Role[]
  /** What the body must be; `project`: a project's text, up to 5 MB. None: the route takes no body. */
  readonly body?: v.GenericSchema | 'project'
  /** Most bytes of a body that is longer than a short form's. */
  readonly most?: number
  handle(call: Call<unknown>): Promise<Answer | Response>
}

type BodyOf<Schema> = Schema extends v.GenericSchema
  ? v.InferOutput<Schema>
  : Schema extends 'project'
    ? string
    : undefined

/** A route whose handler knows the type of its body. */
export const route = <const Schema extends v.GenericSchema | 'project' | undefined = undefined>(
  method: Method,
  path: string,
  roles: readonly Role[],
  handle: (call: Call<BodyOf<Schema>>) => Promise<Answer | Response>,
  body?: Schema,
  most?: number,
): Route => ({
  ...{ method, path, roles },
  ...(body === undefined ? {} : { body }),
  ...(most === undefined ? {} : { most }),
  handle,
})
