// The API's description passes the specification's own schema: what generators, playgrounds and typed clients load first.
import * as jsonSchemaPackage from '@json-schema-tools/meta-schema';
import * as openRpcPackage from '@open-rpc/meta-schema';
import { Ajv, type ValidateFunction } from 'ajv';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';

interface Document {
    methods: { params: object[] }[];
    components: { errors: Record<string, object> };
    [member: string]: unknown;
}

const store = temporaryFolder();
let server: ServerProcess;
let document: Document;

beforeAll(async () => {
    server = await ServerProcess.start({ data: 'flow:abc', store: store.path });
    const response = await fetch(new URL('/openrpc.json', server.link), { headers: { Authorization: `Bearer ${server.token}` } });
    document = (await response.json()) as Document;
});

afterAll(async () => {
    await server.stop();
    store.remove();
});

// Their types know only what they describe, not the descriptions.
const { jsonSchema } = jsonSchemaPackage as unknown as { jsonSchema: object };
const { openrpcDocument } = openRpcPackage as unknown as { openrpcDocument: object };

function referenceSchema(): ValidateFunction {
    const ajv = new Ajv({
        strict: false,
        validateSchema: false, // the two describe themselves by a dialect that only their authors have
        allErrors: true,
        formats: {
            uri: (text: string) => URL.canParse(text),
            'uri-reference': (text: string) => URL.canParse(text, 'http://localhost'),
            regex: true,
        },
    });
    const { $id: _, $schema: _dialect, ...anySchema } = jsonSchema as Record<string, unknown>;
    // The one refers to the other by both spellings.
    for (const $id of ['https://meta.json-schema.tools', 'https://meta.json-schema.tools/']) ajv.addSchema({ ...anySchema, $id });
    const { $schema: _other, ...schema } = openrpcDocument as Record<string, unknown>;
    return ajv.compile(schema);
}

const valid = referenceSchema();

/** Why the reference schema refuses a document. */
function faults(candidate: object): string[] {
    return valid(candidate) ? [] : (valid.errors ?? []).map((each) => `${each.instancePath} ${each.message ?? ''}`);
}

describe('/openrpc.json', () => {
    it('passes the reference meta-schema', () => {
        expect(faults(document)).toEqual([]);
        expect(document.methods.length).toBeGreaterThan(40);
        // It would not, if it had what that schema does not know.
        expect(faults({ ...document, servers: [{ url: '/rpc' }] })).not.toEqual([]);
        expect(faults({ ...document, surplus: 1 })).not.toEqual([]);
        expect(faults({ ...document, openrpc: '2.0' })).not.toEqual([]);
        expect(faults({ ...document, info: undefined })).not.toEqual([]);
        const errors = { broken: { code: 1, message: 'x', 'x-dataSchema': {} } };
        expect(faults({ ...document, components: { ...document.components, errors } })).not.toEqual([]);
        const methods = document.methods.map(({ params: _, ...rest }) => rest);
        expect(faults({ ...document, methods })).not.toEqual([]);
    });
});
